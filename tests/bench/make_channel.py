#!/usr/bin/env python3
"""Writes the boundary document of the domain of tests/peers/rbc_channel.geo: a channel 10 x 4 with three biconcave cells
and a round obstacle, all of them meshed; the closed curves are quadratic B-splines. Usage: make_channel.py > channel.json"""
import json
from math import cos, pi, radians, sin, sqrt

CELLS = [(4.2, 1.25, 20.0, 0.80), (6.0, 2.60, 75.0, 0.80), (8.1, 1.45, -40.0, 0.80)]  # centre, turn, radius
POINTS = 16
curves = []


def add_loop(name, points, face):
    n = len(points)
    curves.append({"name": name, "degree": 2, "closed": True, "knots": list(range(n + 1)),
                   "points": [x for p in points for x in p], "left": face, "right": 0})


corners = [(0, 0), (10, 0), (10, 4), (0, 4)]
for k, name in enumerate(["wall", "outlet", "wall", "inlet"]):
    a, b = corners[k], corners[(k + 1) % 4]
    curves.append({"name": name, "degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [*a, *b],
                   "start": k, "end": (k + 1) % 4, "left": 0, "right": None})
for k, (cx, cy, turn, radius) in enumerate(CELLS):
    outline = []
    for i in range(POINTS):
        t = 2 * pi * (i + 0.5) / POINTS
        c = cos(t)
        half = 0.5 * (0.207 + 2.003 * c * c - 1.123 * c**4) * sqrt(max(0.0, 1 - c * c))
        x, y = radius * c, radius * half * (1 if sin(t) > 0 else -1) * 1.25
        ca, sa = cos(radians(turn)), sin(radians(turn))
        outline.append((cx + ca * x - sa * y, cy + sa * x + ca * y))
    add_loop("membrane", outline, 1 + k)
# A quadratic B-spline of 32 uniform spans whose edges touch the circle of radius 0.5.
add_loop("obstacle boundary", [(2 + 0.5 / cos(pi / 32) * cos(pi * i / 16), 2 + 0.5 / cos(pi / 32) * sin(pi * i / 16))
                               for i in range(32)], 4)
print(json.dumps({"format": "pliant-boundary", "version": 1, "vertices": [x for p in corners for x in p],
                  "faces": [{"name": n} for n in ["plasma", "cell1", "cell2", "cell3", "obstacle"]], "curves": curves}))
