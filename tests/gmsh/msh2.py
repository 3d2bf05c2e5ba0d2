"""Reads the text form of MSH 2.2, and knows Lagrange triangles: independent of what is tested, in exact arithmetic where
it matters."""
from fractions import Fraction
from math import factorial

TRIANGLES = {2: 1, 9: 2, 21: 3, 23: 4, 25: 5, 42: 6, 43: 7, 44: 8, 45: 9, 46: 10}


def read(path):
    """Nodes {number: (x, y)} and triangles [(number, physical, order, nodes)]."""
    with open(path, encoding="utf-8") as file:
        words = iter(file.read().split())
    nodes, triangles = {}, []
    for word in words:
        if word == "$Nodes":
            for _ in range(int(next(words))):
                number = int(next(words))
                nodes[number] = (float(next(words)), float(next(words)))
                next(words)
        elif word == "$Elements":
            lines = int(next(words))
            for _ in range(lines):
                number, kind, tags = (int(next(words)) for _ in range(3))
                values = [int(next(words)) for _ in range(tags)]
                count = NODES[kind]
                own = [int(next(words)) for _ in range(count)]
                if kind in TRIANGLES:
                    triangles.append((number, values[0], TRIANGLES[kind], own))
    return nodes, triangles


NODES = {1: 2, 8: 3, 26: 4, 27: 5, 28: 6, 62: 7, 63: 8, 64: 9, 65: 10, 66: 11, 15: 1}
NODES.update({kind: (p + 1) * (p + 2) // 2 for kind, p in TRIANGLES.items()})


def lattice(order):
    """The exponents (i, j, k) of a triangle's nodes in Gmsh's order: corners, edges, then inside the same again."""
    if order == 0:
        return [(0, 0, 0)]
    nodes = [(order, 0, 0), (0, order, 0), (0, 0, order)]
    for a, b in ((0, 1), (1, 2), (2, 0)):
        for k in range(1, order):
            node = [0, 0, 0]
            node[a], node[b] = order - k, k
            nodes.append(tuple(node))
    if order >= 3:
        nodes += [(i + 1, j + 1, k + 1) for i, j, k in lattice(order - 3)]
    return nodes


def document_order(order):
    """The exponents of a net in the order of a mesh document."""
    edges = [n for n in lattice(order) if 0 in n]
    return edges + [(i, j, order - i - j) for i in range(order - 2, 0, -1) for j in range(order - i - 1, 0, -1)]


def bezier_from_lagrange(order):
    """The exact matrix from nodes (Gmsh's order) to control points (order of a document), by Gauss and Jordan."""
    nodes, control = lattice(order), document_order(order)
    n = len(nodes)
    rows = []
    for r, (a, b, c) in enumerate(nodes):
        row = []
        for i, j, k in control:
            count = factorial(order) // (factorial(i) * factorial(j) * factorial(k))
            row.append(count * Fraction(a, order) ** i * Fraction(b, order) ** j * Fraction(c, order) ** k)
        rows.append(row + [Fraction(int(r == s)) for s in range(n)])
    for c in range(n):
        pivot = next(r for r in range(c, n) if rows[r][c] != 0)
        rows[c], rows[pivot] = rows[pivot], rows[c]
        scale = rows[c][c]
        rows[c] = [x / scale for x in rows[c]]
        for r in range(n):
            factor = rows[r][c]
            if r != c and factor != 0:
                rows[r] = [x - factor * y for x, y in zip(rows[r], rows[c])]
    return [row[n:] for row in rows]


def det_j_of_quadratic(points, u, v):
    """det J at (u, v) of the unit right triangle, for six Lagrange nodes."""
    w = 1 - u - v
    du = (1 - 4 * w, 4 * u - 1, 0, 4 * (w - u), 4 * v, -4 * v)
    dv = (1 - 4 * w, 0, 4 * v - 1, -4 * u, 4 * u, 4 * (w - v))
    xu, yu, xv, yv = (sum(d * p[k] for d, p in zip(ds, points)) for ds in (du, dv) for k in (0, 1))
    return xu * yv - xv * yu


def signed_area(points, order, matrix):
    """Exact area of a Lagrange triangle: by Green's theorem along its edges, in rationals."""
    control = [[sum(m * Fraction(p[k]) for m, p in zip(row, points) if m) for k in (0, 1)] for row in matrix]
    place = {n: c for n, c in zip(document_order(order), control)}
    area = Fraction(0)
    for e in range(3):
        edge = []
        for k in range(order + 1):
            node = [0, 0, 0]
            node[e], node[(e + 1) % 3] = order - k, k
            edge.append(place[tuple(node)])
        # Half the integral of x dy - y dx: sum over pairs of control points.
        p = order
        binomial = lambda n, k: factorial(n) // (factorial(k) * factorial(n - k))
        for i in range(p + 1):
            for j in range(p):
                dx, dy = edge[j + 1][0] - edge[j][0], edge[j + 1][1] - edge[j][1]
                weight = Fraction(binomial(p, i) * binomial(p - 1, j), binomial(2 * p - 1, i + j)) / 2
                area += weight * (edge[i][0] * dy - edge[i][1] * dx) / 2
    return area
