#!/usr/bin/env python3
"""A smooth field carried through a vortex in two ways: the mesh is repaired at every step, or replaced by a new one.

repair: advect | smoothcurves | flipdelaunay | refine | coarsen --tolerance 1e-4 | smoothcurves, fields travel through all of it;
remesh: advect, a new mesh of the moved boundary at the same criteria, its curves coarsened once with the same tolerance, and the field
        interpolated: its value in the old mesh at the lattice nodes of the new elements.

The flow turns each circle around (1.5, 1.5) rigidly, so that the exact field is known at any time. A line of JSON a way and report goes
out. Usage: remesh_or_repair.py --bin build/release/bin [--degree 2|3] [--triangles N] [--steps N] [--ways repair,remesh]
       [--projection limited|conservative|l2]
"""
import argparse
import json
import math
import resource
import sys
import tempfile
import time
from pathlib import Path

from field_integrals import document_order, integrals
from random_cases import closed_spline, polygon_domain
from repair_cases import Tools

RADIUS_SQUARED = 1.44  # the square of the radius of the vortex, beyond which nothing moves
FLOW = ["--vx", f"-(y-1.5)*max(0,1-((x-1.5)^2+(y-1.5)^2)/{RADIUS_SQUARED})^2",
        "--vy", f"(x-1.5)*max(0,1-((x-1.5)^2+(y-1.5)^2)/{RADIUS_SQUARED})^2"]
FIELD = "u=exp(-8*((x-1.9)^2+(y-1.5)^2))+0.3"
OUTSIDE = 1e-9  # a point is inside an element if its barycentric coordinates are above minus this


def exact(x, y, t):
    dx, dy = x - 1.5, y - 1.5
    angle = -t * max(0.0, 1 - (dx * dx + dy * dy) / RADIUS_SQUARED) ** 2
    c, s = math.cos(angle), math.sin(angle)
    return math.exp(-8 * ((1.5 + c * dx - s * dy - 1.9) ** 2 + (s * dx + c * dy) ** 2)) + 0.3


def boundary_document():
    boundary = polygon_domain([(0, 0), (3, 0), (3, 3), (0, 3)], 1)
    circle = [(1.7 + 0.6 * math.cos(2 * math.pi * k / 12), 1.5 + 0.6 * math.sin(2 * math.pi * k / 12)) for k in range(12)]
    boundary["faces"].append({"name": "cell"})
    boundary["curves"].append(dict(closed_spline(circle, 2), name="membrane", left=1, right=0))
    return {"format": "pliant-boundary", "version": 1, **boundary}


class Basis:
    """Bernstein polynomials of a degree in two coordinates, v = xi2 and w = xi3, and the nodes of their lattice."""

    def __init__(self, degree):
        self.degree, self.order = degree, document_order(degree)
        self.up = [self._terms(n) for n in (degree, degree - 1)]
        place = {k: a for a, k in enumerate(self.order)}
        self.steps = []  # weight and indices of the control points whose differences make the derivatives
        for i, j, k, c in self.up[1]:
            self.steps.append((c * degree, i, j, k, place[(i + 1, j, k)], place[(i, j + 1, k)], place[(i, j, k + 1)]))
        self.from_lattice = inverse([self.values(j / degree, k / degree) for _, j, k in self.order])

    def _terms(self, n):
        order = self.order if n == self.degree else [(i, j, n - i - j) for i in range(n + 1) for j in range(n + 1 - i)]
        return [(i, j, k, math.comb(n, i) * math.comb(n - i, j)) for i, j, k in order]

    def powers(self, v, w):
        u, p = 1 - v - w, self.degree
        return [u ** k for k in range(p + 1)], [v ** k for k in range(p + 1)], [w ** k for k in range(p + 1)]

    def values(self, v, w):
        us, vs, ws = self.powers(v, w)
        return [c * us[i] * vs[j] * ws[k] for i, j, k, c in self.up[0]]

    def derivatives(self, xs, ys, v, w):
        us, vs, ws = self.powers(v, w)
        xv = xw = yv = yw = 0.0
        for c, i, j, k, a, b, d in self.steps:
            weight = c * us[i] * vs[j] * ws[k]
            xv += weight * (xs[b] - xs[a])
            xw += weight * (xs[d] - xs[a])
            yv += weight * (ys[b] - ys[a])
            yw += weight * (ys[d] - ys[a])
        return xv, xw, yv, yw


def inverse(matrix):
    """The inverse of a matrix, by Gauss-Jordan elimination with pivots."""
    n = len(matrix)
    rows = [list(row) + [float(i == k) for k in range(n)] for i, row in enumerate(matrix)]
    for c in range(n):
        pivot = max(range(c, n), key=lambda r: abs(rows[r][c]))
        rows[c], rows[pivot] = rows[pivot], rows[c]
        rows[c] = [x / rows[c][c] for x in rows[c]]
        for r in range(n):
            if r != c and rows[r][c]:
                factor = rows[r][c]
                rows[r] = [x - factor * y for x, y in zip(rows[r], rows[c])]
    return [row[n:] for row in rows]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def elements(mesh, basis):
    """For each element, the indices of its control points, their x and their y."""
    size, flat, points = len(basis.order), mesh["triangles"], mesh["points"]
    for t in range(len(mesh["triangle_faces"])):
        ids = flat[t * size:(t + 1) * size]
        yield ids, [points[2 * i] for i in ids], [points[2 * i + 1] for i in ids]


class Locator:
    """The old mesh's value at a point: Newton's method in the elements whose boxes hold it, by a grid of buckets."""

    def __init__(self, mesh, basis):
        self.basis, self.values = basis, mesh["fields"][0]["values"]
        self.elements, self.grid = [], {}
        self.cell = 3 / max(1, math.isqrt(len(mesh["triangle_faces"])))
        for e, (ids, xs, ys) in enumerate(elements(mesh, basis)):
            rim = 1e-3 * self.cell  # interfaces of the new mesh lie off the old ones by the tolerance
            box = min(xs) - rim, min(ys) - rim, max(xs) + rim, max(ys) + rim
            self.elements.append((ids, xs, ys, box))
            for a in range(self.key(box[0]), self.key(box[2]) + 1):
                for b in range(self.key(box[1]), self.key(box[3]) + 1):
                    self.grid.setdefault((a, b), []).append(e)

    def key(self, x):
        return math.floor(x / self.cell)

    def newton(self, element, x, y):
        """Coordinates v and w, and by how much the point is inside; none if there is no convergence."""
        _, xs, ys, _ = element
        v = w = 1 / 3
        for _ in range(20):
            values = self.basis.values(v, w)
            rx, ry = x - dot(values, xs), y - dot(values, ys)
            xv, xw, yv, yw = self.basis.derivatives(xs, ys, v, w)
            det = xv * yw - xw * yv
            if det == 0:
                return None
            dv, dw = (rx * yw - ry * xw) / det, (xv * ry - yv * rx) / det
            v, w = v + dv, w + dw
            if abs(v) > 3 or abs(w) > 3:
                return None
            if abs(dv) + abs(dw) < 1e-10:
                return v, w, min(v, w, 1 - v - w)
        return None

    def value(self, x, y):
        best = None
        for e in self.grid.get((self.key(x), self.key(y)), []):
            element = self.elements[e]
            a, b, c, d = element[3]
            if a <= x <= c and b <= y <= d:
                found = self.newton(element, x, y)
                if found and (best is None or found[2] > best[0]):
                    best = found[2], found, element
                    if found[2] > -OUTSIDE:
                        break
        if best is None:
            raise RuntimeError(f"no element at ({x:.17g}, {y:.17g})")
        ids = best[2][0]
        return dot(self.basis.values(*best[1][:2]), [self.values[i] for i in ids])


def interpolate(function, new, basis):
    """Control values on the new mesh that interpolate a function at the lattice nodes; how many nodes."""
    p = basis.degree
    lattice = [basis.values(j / p, k / p) for _, j, k in basis.order]
    node = {}  # by control point, as elements share edges, and the node on an edge is the same from either side
    values = [0.0] * (len(new["points"]) // 2)
    for ids, xs, ys in elements(new, basis):
        for i, row in zip(ids, lattice):
            if i not in node:
                node[i] = function(dot(row, xs), dot(row, ys))
        # The rows of edge points are zero but on their edge, so that neighbours agree (to rounding).
        for i, row in zip(ids, basis.from_lattice):
            values[i] = dot(row, [node[k] for k in ids])
    return values, len(node)


def gauss(n):
    """Nodes and weights on [0, 1]."""
    rule = []
    for k in range(n):
        x = math.cos(math.pi * (k + 0.75) / (n + 0.5))
        for _ in range(50):
            p, q = 1.0, x
            for m in range(2, n + 1):
                p, q = q, ((2 * m - 1) * x * q - (m - 1) * p) / m
            slope = n * (x * q - p) / (x * x - 1)
            x -= q / slope
        rule.append(((1 + x) / 2, 1 / ((1 - x * x) * slope * slope)))
    return rule


def relative_error(mesh, field, basis, t):
    """The L2 norm of the error of a field, relative to that of the field, by 6 x 6 Gauss points on each element. The rule is
    exact for polynomials up to degree 10."""
    rule, error, norm = gauss(6), [], []
    table = [(a, b * (1 - a), f * g * (1 - a)) for a, f in rule for b, g in rule]
    table = [(v, w, weight, basis.values(v, w)) for v, w, weight in table]
    for ids, xs, ys in elements(mesh, basis):
        us = [field[i] for i in ids]
        for v, w, weight, values in table:
            xv, xw, yv, yw = basis.derivatives(xs, ys, v, w)
            area, u = weight * (xv * yw - xw * yv), exact(dot(values, xs), dot(values, ys), t)
            error.append(area * (dot(values, us) - u) ** 2)
            norm.append(area * u * u)
    return math.sqrt(math.fsum(error) / math.fsum(norm))


def content(mesh):
    return integrals(mesh)[("u", 0, "all")][0]


class Way:
    """One way of keeping the mesh good, step by step."""

    def __init__(self, name, tools, folder, criteria, options):
        self.name, self.tools, self.folder, self.criteria, self.options = name, tools, folder, criteria, options
        self.basis = Basis(options.degree)
        self.seconds, self.passes = {"advect": 0.0, "mesh": 0.0}, {"advect": 0.0, "mesh": 0.0}
        self.located, self.python, self.changed = 0, 0.0, 0.0

    def run(self, arguments, source, target, account):
        """Adds to the processor seconds, the tool's start, reading and writing included, and to those of its passes alone."""
        report = self.folder / "report.json"
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        status, _, said = self.tools.run([*arguments, "-q", "--report", report, source], target)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.seconds[account] += after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        if status:
            sys.exit(f"{self.name}: {arguments[0]} ended with status {status}: {said}")
        phases = json.loads(report.read_text())["seconds"]
        self.passes[account] += sum(s for phase, s in phases.items() if phase not in ("read", "check", "write"))

    def coarsen(self):
        return ["coarsen", "--tolerance", self.options.tolerance]

    def repair(self, moved, target):
        projection = ["--projection", self.options.projection]
        pipe = [["smoothcurves"], ["flipdelaunay"], ["refine"], self.coarsen(), ["smoothcurves"]]
        source = moved
        for k, stage in enumerate(pipe):
            out = target if k + 1 == len(pipe) else self.folder / f"stage{k}.json"
            self.run([*stage, *projection], source, out, "mesh")
            source = out

    def remesh(self, moved, target):
        old, boundary, fresh = json.loads(moved.read_text()), self.folder / "boundary.json", self.folder / "fresh.json"
        boundary.write_text(json.dumps({"format": "pliant-boundary", "version": 1, **old["boundary"]}))
        self.run(["bspline2mesh", *self.criteria, "--time", repr(old["time"])], boundary, fresh, "mesh")
        coarse = self.folder / "coarse.json"
        self.run(self.coarsen(), fresh, coarse, "mesh")
        new, start = json.loads(coarse.read_text()), time.process_time()
        values, count = interpolate(Locator(old, self.basis).value, new, self.basis)
        self.python += time.process_time() - start
        self.located += count
        new["fields"] = [{"name": "u", "components": 1, "by_face": False, "values": values}]
        target.write_text(json.dumps(new))

    def go(self, first):
        mesh, moved = self.folder / f"{self.name}.json", self.folder / "moved.json"
        mesh.write_text(first)
        start = content(json.loads(first))
        self.say(0, json.loads(first), mesh, start, start)
        for step in range(1, self.options.steps + 1):
            self.run(["advect", *FLOW, "--dt", self.options.dt], mesh, moved, "advect")
            before = content(json.loads(moved.read_text()))
            getattr(self, self.name)(moved, mesh)
            now = json.loads(mesh.read_text())
            after = content(now)
            self.changed += after - before
            if step in self.options.report:
                self.say(step, now, mesh, start, after)

    def say(self, step, mesh, path, start, now):
        # u is positive, so that its integral is that of |u|.
        report = self.tools.report(path)
        if report["invalid"] or report["faults"]:
            sys.exit(f"{self.name}: step {step}: the mesh is faulty")
        spans = {(e["curve"], e["span"]) for e in mesh["constrained_edges"]
                 if mesh["boundary"]["curves"][e["curve"]]["name"] == "membrane"}
        t = step * self.options.dt
        anew = interpolate(lambda x, y: exact(x, y, t), mesh, self.basis)[0]  # what this mesh could hold
        print(json.dumps({
            "way": self.name, "degree": self.options.degree, "step": step, "triangles": report["triangles"],
            "membrane spans": len(spans), "advect seconds": round(self.seconds["advect"], 3),
            "mesh seconds": round(self.seconds["mesh"], 3), "mesh passes": round(self.passes["mesh"], 3), "located": self.located,
            "python transfer seconds": round(self.python, 2),
            "error": float(f"{relative_error(mesh, mesh['fields'][0]['values'], self.basis, t):.4g}"),
            "error of the exact field interpolated": float(f"{relative_error(mesh, anew, self.basis, t):.4g}"),
            "drift": float(f"{(now - start) / start:.3g}"), "drift without advect": float(f"{self.changed / start:.3g}"),
            "least angle": round(report["logical_angle"]["min"], 2)}), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, help="folder of the tools")
    parser.add_argument("--degree", type=int, default=2, choices=[2, 3])
    parser.add_argument("--triangles", type=float, default=600, help="about so many; default: 600")
    parser.add_argument("--steps", type=int, default=100)
    parser.add_argument("--dt", type=float, default=0.05)
    parser.add_argument("--tolerance", type=float, default=1e-4, help="of coarsen; 0: no knots are removed")
    parser.add_argument("--projection", default="limited", help="of the repair: l2, conservative or limited, as the tools do")
    parser.add_argument("--ways", default="repair,remesh")
    parser.add_argument("--report", default="10,25,50,100", help="after which steps")
    parser.add_argument("--tool-seconds", type=float, default=60)
    options = parser.parse_args()
    options.report = {int(s) for s in options.report.split(",")} | {options.steps}
    tools = Tools(options.bin, options.tool_seconds)
    criteria = ["--degree", options.degree, "--max-area", f"{1.6 * 9 / options.triangles:.3g}"]
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        boundary, first = folder / "boundary.json", folder / "first.json"
        boundary.write_text(json.dumps(boundary_document()))
        status, _, said = tools.run(["bspline2mesh", "-q", *criteria, "--field", FIELD, boundary], first)
        if status:
            sys.exit(f"bspline2mesh ended with status {status}: {said}")
        for name in options.ways.split(","):
            Way(name, tools, folder, criteria, options).go(first.read_text())


if __name__ == "__main__":
    main()
