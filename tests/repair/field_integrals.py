"""Integrals of the fields of a mesh document, exact but for rounding: products of Bernstein polynomials are summed."""
import math


def product_table(p, q):
    """Triples (i, j, weight): the integral of a product of two Bernstein triangles is the weighted sum of f_i g_j."""
    def indices(n):
        return [(a, b, n - a - b) for a in range(n, -1, -1) for b in range(n - a, -1, -1)]

    def choose(n, k):
        return math.factorial(n) / (math.factorial(k[0]) * math.factorial(k[1]) * math.factorial(k[2]))
    table = []
    for a, i in enumerate(indices(p)):
        for b, j in enumerate(indices(q)):
            s = tuple(x + y for x, y in zip(i, j))
            weight = choose(p, i) * choose(q, j) / choose(p + q, s)
            table.append((i, j, s, weight))
    return table


def document_order(p):
    """Indices of a net in the document's order: corners, edges, inner ones."""
    order = [(p, 0, 0), (0, p, 0), (0, 0, p)]
    for e in range(3):
        for k in range(1, p):
            index = [0, 0, 0]
            index[e], index[(e + 1) % 3] = p - k, k
            order.append(tuple(index))
    for i in range(p - 2, 0, -1):
        for j in range(p - 1 - i, 0, -1):
            order.append((i, j, p - i - j))
    return order


def integrals(mesh):
    """For each component of each field on each face, the integrals of f and of |f| (a bound, element by element)."""
    p, points = mesh["degree"], mesh["points"]
    order = document_order(p)
    size = len(order)
    flat, faces = mesh["triangles"], mesh["triangle_faces"]
    derivative = product_table(p - 1, p - 1)
    content = product_table(p, 2 * p - 2)
    result = {}
    places = {}
    for field in mesh["fields"]:
        if field["by_face"]:
            places[field["name"]] = {(field["places"][2 * k], field["places"][2 * k + 1]): k
                                     for k in range(len(field["places"]) // 2)}
    whole = 1 / ((3 * p - 1) * (3 * p))  # twice the area, halved, over the number of coefficients: 1/((n+1)(n+2))
    for t, face in enumerate(faces):
        ids = flat[t * size:(t + 1) * size]
        x = {k: points[2 * i] for k, i in zip(order, ids)}
        y = {k: points[2 * i + 1] for k, i in zip(order, ids)}

        def along(v, k, axis):
            up = list(k)
            up[axis] += 1
            return p * (v[tuple(up)] - v[(k[0] + 1, k[1], k[2])])
        lower = [(a, b, p - 1 - a - b) for a in range(p) for b in range(p - a)]
        du = {k: (along(x, k, 1), along(y, k, 1)) for k in lower}
        dv = {k: (along(x, k, 2), along(y, k, 2)) for k in lower}
        det = {}
        for i, j, s, weight in derivative:
            det[s] = det.get(s, 0.0) + weight * (du[i][0] * dv[j][1] - du[i][1] * dv[j][0])
        for field in mesh["fields"]:
            values, n, name = field["values"], field["components"], field["name"]
            for c in range(n):
                if field["by_face"]:
                    row = {k: places[name].get((i, face)) for k, i in zip(order, ids)}
                    if None in row.values():
                        continue
                else:
                    row = dict(zip(order, ids))
                f = {k: values[n * i + c] for k, i in row.items()}
                terms = [weight * f[i] * det[j] for i, j, s, weight in content]
                # A continuous field's values on an interface belong to both faces: only its sum is kept.
                entry = result.setdefault((name, c, face if field["by_face"] else "all"), ([], []))
                value = whole * math.fsum(terms)
                entry[0].append(value)
                entry[1].append(whole * math.fsum(map(abs, terms)))
    return {key: (math.fsum(a), math.fsum(b)) for key, (a, b) in result.items()}
