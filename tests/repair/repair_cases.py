#!/usr/bin/env python3
"""Random meshes moved as far as advect goes, or further, and repaired with the plain pipe: do they come out as good as new ones?

Each seed makes a domain with interfaces, a mesh of it with fields, and a flow. The mesh is advected, with nothing in between, until a
step is refused (with --tangled: and then two more are forced, as one). Then

    smoothcurves | flipdelaunay | refine | coarsen --tolerance 0 | smoothcurves

runs at the document's criteria, and what comes out is compared with a new mesh of the moved boundary: README.md beside this file.
Usage: repair_cases.py --bin build/release/bin --seeds 1-200 [--most-triangles N] [--tangled] [--msh] [--keep DIR] [--cache DIR]
"""
import argparse
import json
import math
import random
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

PIPE = [["smoothcurves"], ["flipdelaunay"], ["refine"], ["coarsen", "--tolerance", "0"], ["smoothcurves"]]
MOST_STEPS = 60
FORCED = 2  # so many steps are forced as one with --tangled
REFUSED = 4  # the status of a step that would invert an element
NO_END = -1  # the status of a tool that had to be stopped


class Tools:
    def __init__(self, folder, tool_seconds):
        self.folder = Path(folder).resolve()
        self.tool_seconds = tool_seconds

    def run(self, arguments, out=None):
        """Status, seconds, and what was said."""
        start = time.monotonic()
        with open(out, "wb") if out else open("/dev/null", "wb") as stream:
            try:
                done = subprocess.run([self.folder / arguments[0], *map(str, arguments[1:])], stdout=stream,
                                      stderr=subprocess.PIPE, timeout=self.tool_seconds)
            except subprocess.TimeoutExpired:
                return NO_END, time.monotonic() - start, f"no end within {self.tool_seconds:g} s"
        return done.returncode, time.monotonic() - start, done.stderr.decode()

    def report(self, mesh):
        done = subprocess.run([self.folder / "qualityreport", "--format", "json", "--bins", "0", "--worst", "0", mesh],
                              capture_output=True, check=True)
        return json.loads(done.stdout)


# ---- cases


def clamped_line(a, b, degree):
    points = [a[i] + (b[i] - a[i]) * k / degree for k in range(degree + 1) for i in (0, 1)]
    return {"degree": degree, "closed": False, "knots": [0] * (degree + 1) + [1] * (degree + 1), "points": points}


def closed_spline(points, degree):
    return {"degree": degree, "closed": True, "knots": list(range(len(points) + 1)),
            "points": [x for p in points for x in p]}


def blob(random_, centre, radius, count):
    """A wavy oval's control points, counter-clockwise."""
    squeeze, turn = random_.uniform(0.5, 1), random_.uniform(0, math.pi)
    waves, height = random_.randint(2, 5), random_.choice([0, random_.uniform(0, 0.15)])
    points = []
    for k in range(count):
        t = 2 * math.pi * k / count
        r = radius * (1 + height * math.cos(waves * t))
        x, y = r * math.cos(t), squeeze * r * math.sin(t)
        points.append((centre[0] + x * math.cos(turn) - y * math.sin(turn),
                       centre[1] + x * math.sin(turn) + y * math.cos(turn)))
    return points


def polygon_domain(corners, degree):
    n = len(corners)
    curves = [dict(clamped_line(corners[k], corners[(k + 1) % n], degree), name=f"side {k}", start=k, end=(k + 1) % n,
                   left=0, right=None) for k in range(n)]
    return {"vertices": [x for c in corners for x in c], "curves": curves, "faces": [{"name": "outside"}]}


def make_case(seed, most_triangles):
    """The boundary document, arguments of bspline2mesh, and those of advect without the time step."""
    r = random.Random(seed)
    degree = r.choice([1, 2, 2, 2, 3, 4])
    curve_degree = 1 if degree == 1 else r.randint(2, degree)
    kind = r.choice(["channel", "channel", "box", "ell", "annulus"])
    if kind == "annulus":
        inner, outer = 0.6, 2.0
        boundary = {"vertices": [], "curves": [], "faces": [{"name": "outside"}]}
        d = max(2, curve_degree) if degree > 1 else 1
        for name, radius, sides in (("outer", outer, (0, None)), ("inner", inner, (None, 0))):
            points = [(radius * math.cos(2 * math.pi * k / 24), radius * math.sin(2 * math.pi * k / 24))
                      for k in range(24)]
            boundary["curves"].append(dict(closed_spline(points, d), name=name, left=sides[0], right=sides[1]))
        centre, room, area = (1.3, 0.0), 0.5, math.pi * (outer ** 2 - inner ** 2)
    elif kind == "ell":
        boundary = polygon_domain([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)], min(degree, 1) or 1)
        centre, room, area = (1.0, 1.0), 0.9, 12.0
    else:
        size = (6.0, 3.0) if kind == "channel" else (3.0, 3.0)
        boundary = polygon_domain([(0, 0), (size[0], 0), size, (0, size[1])], 1)
        centre, room, area = (size[0] / 2, 1.5), 1.35, size[0] * size[1]
    interfaces = r.choice([0, 1, 1, 2])
    for k in range(interfaces):  # one in the other
        radius = room * 0.55 * 0.55 ** k
        count = r.randint(max(8, curve_degree + 2), 20) if degree > 1 else 24
        boundary["faces"].append({"name": f"cell{k}"})
        offset = 0.1 * radius
        boundary["curves"].append(dict(
            closed_spline(blob(r, (centre[0] + r.uniform(-offset, offset), centre[1] + r.uniform(-offset, offset)),
                               radius, count), max(curve_degree, 1 if degree == 1 else 2)),
            name=f"membrane {k}", left=k + 1, right=k))
    document = {"format": "pliant-boundary", "version": 1, **boundary}
    triangles = math.exp(r.uniform(math.log(25), math.log(most_triangles)))
    mesh = ["--degree", degree, "--max-area", f"{1.6 * area / triangles:.3g}"]
    mesh += ["--field", "u=sin(2*x)*cos(y)+0.3*x"]
    for face in r.sample(boundary["faces"], 1):
        mesh += ["--field", f"w@{face['name']}=x*y-0.4"]

    def vortex(x, y, radius, turn):
        bump = f"max(0,1-((x-({x}))^2+(y-({y}))^2)/{radius ** 2:.6g})^3"
        return f"-({turn})*(y-({y}))*{bump}", f"({turn})*(x-({x}))*{bump}"

    choice = r.choice(["vortex", "vortex", "two", "cells", "stretch", "shear"])
    if kind == "annulus":
        bump = "max(0,(x^2+y^2-0.38)*(3.6-x^2-y^2)/2.6)^2"
        flow = (f"-y*{bump}", f"x*{bump}") if choice in ("shear", "cells", "stretch") else vortex(
            round(centre[0] + r.uniform(-0.1, 0.1), 3), round(r.uniform(-0.3, 0.3), 3), 0.95 * room, r.choice([1, -1.5]))
    elif choice == "vortex" or (kind == "ell" and choice != "two"):
        flow = vortex(round(centre[0] + r.uniform(-0.3, 0.3) * room, 3), centre[1], 0.7 * room, r.choice([1, -2]))
    elif choice == "two":
        shift = 0.45 * room
        one = vortex(round(centre[0] - shift, 3), centre[1], 0.5 * room, 1.5)
        two = vortex(round(centre[0] + shift, 3), centre[1], 0.5 * room, r.choice([-1.5, 1.5]))
        flow = tuple(f"{a}+{b}" for a, b in zip(one, two))
    else:
        w, h = size
        n, m = r.choice([(1, 1), (2, 1), (1, 2)])
        a, b = f"({n * math.pi / w:.17g}*x)", f"({m * math.pi / h:.17g}*y)"
        if choice == "cells":  # no-slip, stream function sin^2 sin^2
            flow = (f"sin{a}^2*sin(2*{b})*{m * math.pi / h:.6g}", f"-sin(2*{a})*sin{b}^2*{n * math.pi / w:.6g}")
        elif choice == "stretch":  # slips along the sides
            flow = (f"sin{a}*cos{b}*{m * math.pi / h:.6g}", f"-cos{a}*sin{b}*{n * math.pi / w:.6g}")
        else:  # shear, with bumps so that the sides stay
            flow = (f"sin({math.pi / w:.17g}*x)^2*sin({2 * math.pi / h:.17g}*y)", "0*x")
    step = r.choice([0.05, 0.1, 0.2])
    return document, mesh, ["--vx", flow[0], "--vy", flow[1]], step, f"degree {degree}, {kind}, {choice}"


def shrink_inner(document):
    """Makes the inner one of two membranes smaller, as it may cross the outer one; whether there is one."""
    for curve in document["curves"]:
        if curve["name"] == "membrane 1":
            x, y = curve["points"][::2], curve["points"][1::2]
            centre = sum(x) / len(x), sum(y) / len(y)
            curve["points"] = [centre[k % 2] + 0.75 * (v - centre[k % 2]) for k, v in enumerate(curve["points"])]
            return True
    return False


def prepare(tools, seed, folder, options):
    """Writes moved.json and fresh.json; a word on the case, and why there is no fresh mesh, if so."""
    document, mesh, flow, step, word = make_case(seed, options.most_triangles)
    boundary, moved, work = folder / "boundary.json", folder / "moved.json", folder / "work.json"
    for _ in range(6):
        boundary.write_text(json.dumps(document))
        status, _, said = tools.run(["bspline2mesh", "-q", *mesh, boundary], moved)
        if status == 0 or not shrink_inner(document):
            break
    if status:
        raise RuntimeError(f"seed {seed}: bspline2mesh: {said}")
    steps = 0
    while steps < MOST_STEPS:
        status, _, said = tools.run(["advect", "-q", *flow, "--dt", step, moved], work)
        if status == REFUSED:
            break
        if status:
            raise RuntimeError(f"seed {seed}: advect ended with status {status}: {said}")
        work.replace(moved)
        steps += 1
    if options.tangled:
        # One long step, since the next would not read what is not valid.
        forced = ["--force", "--substeps", FORCED, "--dt", FORCED * step]
        status, _, said = tools.run(["advect", "-q", *forced, *flow, moved], work)
        if status:
            raise RuntimeError(f"seed {seed}: advect --force ended with status {status}: {said}")
        work.replace(moved)
    moved_mesh = json.loads(moved.read_text())
    again = {"format": "pliant-boundary", "version": 1, **moved_mesh["boundary"]}
    boundary.write_text(json.dumps(again))
    status, _, said = tools.run(["bspline2mesh", "-q", *mesh[:4], boundary], folder / "fresh.json")
    return f"{word}, {steps} steps of {step}", f"bspline2mesh ended with status {status}: {said}" if status else ""


# ---- integrals, exactly but for rounding


def product_table(p, q):
    """For Bernstein triangles: (i, j, weight) so that the integral of a product is the weighted sum of f_i g_j."""
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
    """Of each component of each field on each face: the integral of f and of |f| (by elements)."""
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


# ---- what must hold


def least(report, metric):
    return report[metric]["min"]


def integral_faults(before, after):
    """Signed where elements are inverted."""
    was, now, faults = integrals(before), integrals(after), []
    for key, (value, absolute) in was.items():
        change = now.get(key, (0, 0))[0] - value
        if not abs(change) <= 1e-13 * absolute:
            faults.append(("integral", f"{key}: {change:.3g} of {absolute:.3g}"))
    return faults


def examine(tools, folder, times, statuses, options):
    """A list of (kind, text) of what does not hold."""
    faults = [("status", f"{tool} ended with status {status}: {said.strip().splitlines()[-1] if said else ''}")
              for tool, status, said in statuses if status]
    if faults:
        return faults
    repaired, fresh = tools.report(folder / "repaired.json"), tools.report(folder / "fresh.json")
    if repaired["invalid"] or repaired.get("degenerate"):
        faults.append(("invalid", f"{repaired['invalid']} elements"))
    if repaired["faults"]:
        faults.append(("faults", str(repaired["faults"])[:200]))
    tau = least(repaired, "logical_tau")
    if not tau > 0:
        faults.append(("turned over", f"least logical tau {tau:.3g}"))
    moved = json.loads((folder / "moved.json").read_text())
    asked = moved.get("criteria", {}).get("min_angle", 20)
    bound = min(20, asked, least(fresh, "logical_angle"))
    for metric, limit, kind in (("logical_angle", bound - 1e-9, "angle"),
                                ("scaled_jacobian", min(0.25, 0.8 * least(fresh, "scaled_jacobian")), "jacobian"),
                                ("shape", min(0.2, 0.8 * least(fresh, "shape")), "shape")):
        if least(repaired, metric) < limit:
            faults.append((kind, f"{least(repaired, metric):.4g} where {limit:.4g} is asked for"))
    now, new = repaired["triangles"], fresh["triangles"]
    if now > 1.3 * new and now > new + 4:
        faults.append(("triangles", f"{now} where a new mesh has {new}"))
    read = json.loads((folder / "read.json").read_text()) if options.msh else moved
    faults += integral_faults(read, json.loads((folder / "repaired.json").read_text()))
    if sum(times) > options.most_seconds:
        faults.append(("time", f"{sum(times):.2f} s"))
    return faults


def run_case(tools, seed, options):
    name = f"{seed}{'t' if options.tangled else ''}-{options.most_triangles}"
    cache = Path(options.cache) / name if options.cache else None
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        if cache and cache.exists():
            shutil.copytree(cache, folder, dirs_exist_ok=True)
        else:
            (folder / "word").write_text("\n".join(prepare(tools, seed, folder, options)))
            if cache:
                shutil.copytree(folder, cache)
        word, _, no_fresh = (folder / "word").read_text().partition("\n")
        if no_fresh:  # Forced steps may tangle the boundary; that of a valid mesh is in order.
            if options.tangled:
                return {"seed": seed, "case": word, "skipped": no_fresh}
            return {"seed": seed, "case": word, "faults": [("fresh", no_fresh)]}
        if options.only_advect:
            return {"seed": seed, "case": word, "faults": []}
        source, times, statuses, criteria = folder / "moved.json", [], [], []
        if options.msh:
            statuses.append(("export-msh", *tools.run(["export-msh", "-q", source], folder / "moved.msh")[::2]))
            source = folder / "read.json"
            mesh = make_case(seed, options.most_triangles)[1]  # MSH has neither fields nor criteria.
            fields, criteria = mesh[4:], mesh[2:4]
            read = tools.run(["import-msh", "-q", *fields, folder / "moved.msh"], source)
            statuses.append(("import-msh", *read[::2]))
        for k, stage in enumerate(PIPE):
            target = folder / ("repaired.json" if k + 1 == len(PIPE) else f"stage{k + 1}.json")
            asked = criteria if stage[0] in ("refine", "coarsen") else []
            status, seconds, said = tools.run([*stage, *asked, "-q", source], target)
            times.append(seconds)
            statuses.append((stage[0], status, said))
            source = target
            if status:
                break
        faults = examine(tools, folder, times, statuses, options)
        if faults and options.keep:
            shutil.copytree(folder, Path(options.keep) / str(seed), dirs_exist_ok=True)
        count = tools.report(folder / "moved.json")["triangles"]
        return {"seed": seed, "case": word, "triangles": count, "seconds": [round(s, 3) for s in times], "faults": faults}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, help="folder of the tools")
    parser.add_argument("--seeds", default="1-200", help="A-B, or a list with commas")
    parser.add_argument("--most-triangles", type=float, default=10000)
    parser.add_argument("--most-seconds", type=float, default=1e9)
    parser.add_argument("--tool-seconds", type=float, default=30, help="a tool that takes longer is stopped: a fault")
    parser.add_argument("--jobs", type=int, default=1, help="cases at a time")
    parser.add_argument("--tangled", action="store_true", help="force two more steps, as one")
    parser.add_argument("--msh", action="store_true", help="through export-msh and import-msh, without curves' names")
    parser.add_argument("--keep", help="copies what fails to this folder")
    parser.add_argument("--cache", help="moved meshes are taken from here, and put here")
    parser.add_argument("--only-advect", action="store_true")
    parser.add_argument("--allowed", type=int, default=0, help="so many cases may fail")
    options = parser.parse_args()
    tools = Tools(options.bin, options.tool_seconds)
    if "-" in options.seeds:
        first, last = map(int, options.seeds.split("-"))
        seeds = range(first, last + 1)
    else:
        seeds = [int(s) for s in options.seeds.split(",")]
    kinds, failed, skipped = {}, [], 0
    with ThreadPoolExecutor(options.jobs) as pool:  # Threads suffice: the time goes into the tools.
        for result in pool.map(lambda seed: run_case(tools, seed, options), seeds):
            print(json.dumps(result), flush=True)
            skipped += "skipped" in result
            if result.get("faults"):
                failed.append(result["seed"])
                for kind in dict.fromkeys(kind for kind, _ in result["faults"]):
                    kinds.setdefault(kind, []).append(result["seed"])
    print(f"{len(seeds)} cases, {skipped} skipped, {len(failed)} failed: {failed}")
    for kind, found in sorted(kinds.items()):
        print(f"  {kind}: {len(found)}: {found}")
    sys.exit(len(failed) > options.allowed or skipped > len(seeds) // 4)


if __name__ == "__main__":
    main()
