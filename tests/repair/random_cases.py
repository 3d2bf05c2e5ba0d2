"""Domains with interfaces, meshes, fields and flows, made from seeds: the input of repair_cases.py."""
import math
import random


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
    for k in range(interfaces):  # each lies in the one before
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
    """Makes the inner one of two membranes smaller, since it may cross the outer one. Returns whether there are two."""
    for curve in document["curves"]:
        if curve["name"] == "membrane 1":
            x, y = curve["points"][::2], curve["points"][1::2]
            centre = sum(x) / len(x), sum(y) / len(y)
            curve["points"] = [centre[k % 2] + 0.75 * (v - centre[k % 2]) for k, v in enumerate(curve["points"])]
            return True
    return False
