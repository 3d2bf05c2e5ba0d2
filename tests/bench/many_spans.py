#!/usr/bin/env python3
"""Writes boundary documents with one curve of very many spans: what a tool costs must grow with the spans as n log n.

Usage: many_spans.py SPANS [closed|open|svg] > document

closed   a ring: an outer square and a closed quadratic B-spline of SPANS spans, both sides of which are meshed
open     a square cut in two by an open quadratic B-spline of SPANS spans (a wave), an inner interface
svg      the closed one's corners as one path of SPANS segments, for import-svg"""
import json
import sys
from math import cos, pi, sin


def square(side, faces, chord):
    corners = [(-side, -side), (side, -side), (side, side), (-side, side)]
    for k in range(4):
        a, b = corners[k], corners[(k + 1) % 4]
        faces.append({"name": f"wall{k}", "degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [*a, *b],
                      "start": k, "end": (k + 1) % 4, "left": 0, "right": None})
    return corners


def write(vertices, names, curves):
    json.dump({"format": "pliant-boundary", "version": 1, "vertices": [x for p in vertices for x in p],
               "faces": [{"name": n} for n in names], "curves": curves}, sys.stdout)


def closed(spans):
    curves = []
    corners = square(2, curves, spans)
    points = []
    for i in range(spans):
        t = 2 * pi * i / spans
        r = 1 + 0.2 * cos(5 * t)
        points += [r * cos(t), r * sin(t)]
    curves.append({"name": "membrane", "degree": 2, "closed": True, "knots": list(range(spans + 1)), "points": points,
                   "left": 1, "right": 0})
    write(corners, ["outside", "inside"], curves)


def opened(spans):
    curves = []
    corners = [(0, 0), (1, 0), (1, -1), (0, -1), (1, 1), (0, 1)]
    for k, (a, b, face) in enumerate([(3, 2, 0), (2, 1, 0), (0, 3, 0), (1, 4, 1), (4, 5, 1), (5, 0, 1)]):
        curves.append({"name": f"wall{k}", "degree": 1, "closed": False, "knots": [0, 0, 1, 1],
                       "points": [*corners[a], *corners[b]], "start": a, "end": b, "left": face, "right": None})
    count = spans + 2
    points = []
    for i in range(count):
        x = 0 if i == 0 else 1 if i == count - 1 else (i - 0.5) / spans
        points += [x, 0 if i in (0, count - 1) else 0.2 * sin(2 * pi * x)]
    curves.append({"name": "interface", "degree": 2, "closed": False, "knots": [0, 0, *range(spans + 1), spans, spans],
                   "points": points, "start": 0, "end": 1, "left": 1, "right": 0})
    write(corners, ["below", "above"], curves)


def svg(spans):
    path = []
    for i in range(spans):
        t = 2 * pi * i / spans
        r = 400 * (1 + 0.2 * cos(5 * t))
        path.append(f"{500 + r * cos(t):.7g},{500 + r * sin(t):.7g}")
    print('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 1000"><path d="M' + " L".join(path) + 'Z"/></svg>')


if __name__ == "__main__":
    {"closed": closed, "open": opened, "svg": svg}[sys.argv[2] if len(sys.argv) > 2 else "closed"](int(sys.argv[1]))
