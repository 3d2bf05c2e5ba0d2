"""boundary: boundary documents made of circles and polygons, for the scripts that write a sample's start."""
import json
import math
import sys


def circle(centre, radius, degree, spans):
    """The control points of a closed spline with even knots that stands for a circle; a knot is at its right.

    They lie on a circle, too, one that is larger by (x/sin x)^(degree + 1), where x is half of the angle of a span. The
    radius of the curve then is `radius` on average, and differs from it nowhere by more than about 2/spans^(degree + 1)
    of it where the degree is odd, and 2 (degree + 1)/spans^(degree + 2) where it is even. Degree 1 is left as
    it is: a polygon whose corners lie on the circle."""
    half = math.pi / spans
    outside = radius if degree == 1 else radius * (half / math.sin(half)) ** (degree + 1)
    points = []
    for k in range(spans):
        angle = 2 * half * (k if degree % 2 else k + 0.5)
        points += [centre[0] + outside * math.cos(angle), centre[1] + outside * math.sin(angle)]
    return points


def interpolated(curve, knots, degree):
    """The control points of a closed spline with these knots (one period, both ends) that meets curve(t), a point, at the
    means of degree successive knots (Greville's abscissae)."""
    count, period = len(knots) - 1, knots[-1] - knots[0]

    def knot(i):
        return knots[i % count] + period * (i // count)

    matrix = [[0.0] * count for _ in range(count)]
    places = [sum(knot(i + j) for j in range(1, degree + 1)) / degree for i in range(count)]
    for row, t in enumerate(places):
        span = max(i for i in range(row, row + degree + 1) if knot(i) <= t)
        values = [1.0]  # of the basis functions that end with this span, by the recursion of Cox and de Boor
        for k in range(1, degree + 1):
            above = [0.0, *values, 0.0]
            weight = lambda i: (t - knot(i)) / (knot(i + k) - knot(i))
            values = [(weight(span - k + j) if j > 0 else 0) * above[j]
                      + (1 - weight(span - k + j + 1) if j < k else 0) * above[j + 1] for j in range(k + 1)]
        for j, value in enumerate(values):
            matrix[row][(span - degree + j) % count] += value
    return [c for point in solved(matrix, [curve(t) for t in places]) for c in point]


def solved(matrix, right):
    """The solution of a system with several right sides, by elimination with pivoting."""
    rows = [[*row, *values] for row, values in zip(matrix, right)]
    count = len(rows)
    for k in range(count):
        pivot = max(range(k, count), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, count):
            factor = rows[i][k] / rows[k][k]
            if factor:
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    for k in reversed(range(count)):
        rows[k] = [a / rows[k][k] for a in rows[k]]
        for i in range(k):
            if rows[i][k]:
                rows[i] = [a - rows[i][k] * b for a, b in zip(rows[i], rows[k])]
    return [row[count:] for row in rows]


class Boundary:
    """Curves and faces of a boundary document, in the order in which they are added."""

    def __init__(self, *faces):
        self.faces = list(faces)
        self.vertices = []
        self.curves = []

    def closed(self, name, degree, points, left, right, knots=None):
        """Adds a closed curve, with even knots if none are given, and the names of the faces beside it (None: outside)."""
        self.curves.append({"name": name, "degree": degree, "closed": True,
                            "knots": knots or list(range(len(points) // 2 + 1)), "points": points,
                            "left": self.face(left), "right": self.face(right)})

    def open(self, name, degree, points, left, right):
        """Adds an open curve with even knots; where it begins or ends on a vertex that there is, it meets it."""
        spans = len(points) // 2 - degree
        self.curves.append({"name": name, "degree": degree, "closed": False,
                            "knots": [0] * degree + list(range(spans + 1)) + [spans] * degree, "points": points,
                            "start": self.vertex(points[:2]), "end": self.vertex(points[-2:]),
                            "left": self.face(left), "right": self.face(right)})

    def polygon(self, corners, names, left, right):
        """Adds the sides of a polygon, each a curve with a name of its own."""
        for name, start, end in zip(names, corners, corners[1:] + corners[:1]):
            self.open(name, 1, [*start, *end], left, right)

    def vertex(self, point):
        point = list(point)
        if point not in self.vertices:
            self.vertices.append(point)
        return self.vertices.index(point)

    def face(self, name):
        return None if name is None else self.faces.index(name)

    def write(self):
        json.dump({"format": "pliant-boundary", "version": 1, "vertices": [x for point in self.vertices for x in point],
                   "faces": [{"name": name} for name in self.faces], "curves": self.curves}, sys.stdout)
        print()
