#!/usr/bin/env python3
"""orders.py SOURCE [DEGREE LEVELS [PROJECTION]]: observed orders of diffuse on a mesh that a vortex moves, with all passes on.

The solution sin(3x + t) cos(2y) is given by its source; a circle is carried along. Sizes are halved from level to level, and
the step so that its second order does not hide that of space. An order is that in the root of the number of triangles.
Prints a table; without DEGREE, checks a small one.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

END, DIFFUSIVITY = 0.4, 0.05
VX = "-cos(pi*t/2)*sin(pi*x)^2*sin(2*pi*y)"
VY = "cos(pi*t/2)*sin(pi*y)^2*sin(2*pi*x)"
EXACT = "sin(3*x+t)*cos(2*y)"
SOURCE = (f"cos(3*x+t)*cos(2*y)*(1+3*({VX})) - 2*({VY})*sin(3*x+t)*sin(2*y) + {13 * DIFFUSIVITY}*{EXACT}")
PROBLEM = {"format": "pliant-problem", "version": 1,
           "diffuse": {"field": "c", "materials": {"*": {"diffusivity": DIFFUSIVITY, "source": SOURCE}},
                       "conditions": [{"curve": "*", "value": EXACT}], "initial": EXACT}}


def run(source, degree, level, projection):
    """The errors at the end, and how much was done on the way."""
    area, accuracy = 0.02 / 4 ** level, 2e-4 / 2 ** ((degree + 1) * level)
    steps = math.ceil(20 * 2 ** (level * (degree + 1) / 2))
    start = subprocess.run([source / "samples/vortex/make-start", str(degree), str(accuracy)], check=True, capture_output=True)
    mesh = subprocess.run(["bspline2mesh", "--max-area", str(area), "--accuracy", str(accuracy)], input=start.stdout, check=True,
                          capture_output=True)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "problem.json").write_text(json.dumps(PROBLEM))
        step = (f"diffuse --problem {folder}/problem.json --vx '{VX}' --vy '{VY}' --dt {END / steps} --error '{EXACT}' | "
                f"flipdelaunay --projection {projection} | refine | "
                f"coarsen --projection {projection} --region-change conserve | smoothcurves --projection {projection}")
        subprocess.run(["evolve", "-q", "--until", str(END), "--log", folder / "log", "-o", folder / "out.jsonl", step, "-"],
                       input=mesh.stdout, check=True)
        lines = [json.loads(line) for line in (folder / "log").read_text().splitlines()]
    values = lines[-1]["stages"][0]["values"]
    counts = [sum(stage["values"].get(name, 0) for line in lines for stage in line["stages"])
              for name in ("flips", "insertions", "removals")]
    return values["error_l2"], values["error_h1"], lines[-1]["triangles"], steps, counts


def table(source, degree, levels, projection):
    """The orders between the last two levels."""
    print(f"degree {degree}, --projection {projection}")
    print("  triangles  steps   flips insertions removals        L2  order        H1  order")
    before, orders = None, (0, 0)
    for level in range(levels):
        l2, h1, triangles, steps, (flips, insertions, removals) = run(source, degree, level, projection)
        if before:
            finer = math.log(triangles / before[2]) / 2
            orders = (math.log(before[0] / l2) / finer, math.log(before[1] / h1) / finer)
        shown = [f"{order:6.2f}" if before else " " * 6 for order in orders]
        print(f"  {triangles:9} {steps:6} {flips:7.0f} {insertions:10.0f} {removals:8.0f}  {l2:8.2e} {shown[0]}  {h1:8.2e} {shown[1]}",
              flush=True)
        before = l2, h1, triangles
    return orders


def main():
    source = pathlib.Path(sys.argv[1])
    if len(sys.argv) > 2:
        table(source, int(sys.argv[2]), int(sys.argv[3]), sys.argv[4] if len(sys.argv) > 4 else "conservative")
        return
    l2, h1 = table(source, 2, 2, "conservative")
    assert l2 > 2.5 and h1 > 1.5, (l2, h1)


main()
