#!/usr/bin/env python3
"""orders.py SOURCE [MESH DEGREE LEVELS]: observed orders of navierstokes on curved meshes.

The velocity, of which the stream function is sin(pi x)^2 sin(pi y)^2 cos(t)/pi, is given by its force, and so is the pressure
sin(2x + t) cos(3y). MESH is `rest`, a mesh whose elements around a circle are curved, which does not move; `moving`, where the
circle is an interface that goes with the flow, with all passes on. Sizes are halved from level to level, and the step so that
its second order does not hide that of space; an order is that in the root of the number of triangles. With `steps` the mesh
rests, with `steps-moving` it goes with the flow, but no pass runs: the flow swings faster (cos(20 t)/2 in place of cos(pi t/2)),
and steps alone are halved. Prints a table; without MESH, checks a small one.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

END, VISCOSITY, DENSITY = 0.4, 0.05, 1
SLOW = "cos(pi*t/2)", "(-pi/2*sin(pi*t/2))"  # the amplitude and its derivative
FAST = "(cos(20*t)/2)", "(-10*sin(20*t))"
U, V = "-sin(pi*x)^2*sin(2*pi*y)", "sin(pi*y)^2*sin(2*pi*x)"
P = "sin(2*x+t)*cos(3*y)"


def force(amplitude, rate):
    """density (du/dt + u grad u) - viscosity laplace u + grad p, for u = amplitude (U, V)."""
    ux, uy = "(-pi*sin(2*pi*x)*sin(2*pi*y))", "(-2*pi*sin(pi*x)^2*cos(2*pi*y))"
    vx, vy = "(2*pi*sin(pi*y)^2*cos(2*pi*x))", "(pi*sin(2*pi*y)*sin(2*pi*x))"
    laplace_u = "(-2*pi^2*cos(2*pi*x)*sin(2*pi*y) + 4*pi^2*sin(pi*x)^2*sin(2*pi*y))"
    laplace_v = "(2*pi^2*cos(2*pi*y)*sin(2*pi*x) - 4*pi^2*sin(pi*y)^2*sin(2*pi*x))"
    px, py = "2*cos(2*x+t)*cos(3*y)", "(-3*sin(2*x+t)*sin(3*y))"
    return [f"{DENSITY}*({rate}*({w}) + {amplitude}^2*(({U})*{wx} + ({V})*{wy})) - {VISCOSITY}*{amplitude}*{laplace} + {p}"
            for w, wx, wy, laplace, p in ((U, ux, uy, laplace_u, px), (V, vx, vy, laplace_v, py))]


def problem(amplitude, rate):
    velocity = [f"{amplitude}*({U})", f"{amplitude}*({V})"]
    return {"format": "pliant-problem", "version": 1,
            "navierstokes": {"materials": {"*": {"density": DENSITY, "viscosity": VISCOSITY}},
                             "conditions": [{"curve": "*", "velocity": velocity}], "force": force(amplitude, rate),
                             "initial": velocity}}


# The mean of the pressure is 0 in an enclosed flow: this is what the pressure above has on the unit square.
MEAN = "((cos(t) - cos(2+t))/2*sin(3)/3)"


def run(source, kind, degree, level):
    """The errors at the end, and how much was done on the way."""
    in_time = kind.startswith("steps")
    space = 1 if in_time else level
    area, accuracy = 0.02 / 4 ** space, 2e-4 / 2 ** ((degree + 1) * space)
    steps = 10 * 2 ** level if in_time else math.ceil(10 * 2 ** (level * (degree + 1) / 2))
    given = problem(*(FAST if in_time else SLOW))
    start = subprocess.run([source / "samples/vortex/make-start", str(degree), str(accuracy)], check=True, capture_output=True)
    mesh = subprocess.run(["bspline2mesh", "--max-area", str(area), "--accuracy", str(accuracy)], input=start.stdout, check=True,
                          capture_output=True)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "problem.json").write_text(json.dumps(given))
        step = f"navierstokes --problem {folder}/problem.json --dt {END / steps}"
        for name, exact in zip(("velocity_x", "velocity_y", "pressure"), [*given["navierstokes"]["initial"], f"{P} - {MEAN}"]):
            step += f" --error '{name}={exact}'"
        step += {"moving": " | flipdelaunay | refine | coarsen | smoothcurves", "steps-moving": ""}.get(kind, " --mesh-velocity fixed")
        subprocess.run(["evolve", "-q", "--until", str(END), "--log", folder / "log", "-o", folder / "out.jsonl", step, "-"],
                       input=mesh.stdout, check=True)
        lines = [json.loads(line) for line in (folder / "log").read_text().splitlines()]
    values = lines[-1]["stages"][0]["values"]
    counts = [sum(stage["values"].get(name, 0) for line in lines for stage in line["stages"])
              for name in ("flips", "insertions", "removals")]
    errors = [math.hypot(values[f"{norm}:velocity_x"], values[f"{norm}:velocity_y"]) for norm in ("error_l2", "error_h1")]
    return [*errors, values["error_l2:pressure"]], lines[-1]["triangles"], steps, counts


def table(source, kind, degree, levels):
    """The orders between the last two levels."""
    print(f"{kind}, degree {degree}")
    print("  triangles  steps   flips insertions removals  velocity  order        H1  order  pressure  order")
    before, orders = None, []
    for level in range(levels):
        errors, triangles, steps, counts = run(source, kind, degree, level)
        if before:
            finer = math.log(2) if kind.startswith("steps") else math.log(triangles / before[1]) / 2
            orders = [math.log(old / new) / finer for old, new in zip(before[0], errors)]
        shown = "  ".join(f"{error:8.2e} {f'{order:6.2f}' if before else '      '}"
                          for error, order in zip(errors, orders or errors))
        print(f"  {triangles:9} {steps:6} {counts[0]:7.0f} {counts[1]:10.0f} {counts[2]:8.0f}  {shown}", flush=True)
        before = errors, triangles
    return orders


def main():
    source = pathlib.Path(sys.argv[1])
    if len(sys.argv) > 2:
        table(source, sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))
        return
    for kind, degree, least in (("rest", 2, (2.6, 1.6, 1.7)), ("moving", 2, (2.4, 1.5, 1.5)), ("steps-moving", 3, (1.8, 1.8, 0.8))):
        orders = table(source, kind, degree, 2)
        assert all(order > bound for order, bound in zip(orders, least)), (kind, degree, orders)


main()
