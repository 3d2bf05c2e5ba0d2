#!/usr/bin/env python3
"""domains.py SOURCE NAME [NUMBERS]: the boundary documents of navierstokes.sh, on standard output.

channel DEGREE, of 2 by 1; layers DEGREE Y, a channel of two faces on each other; drop DEGREE SPANS RADIUS, a circle in a square of half-width 2;
parts, two squares apart; corner, two squares that meet in one point; disk DEGREE SPANS."""
import sys

sys.dont_write_bytecode = True  # nothing is left beside the samples
sys.path.insert(0, sys.argv[1] + "/samples/common")
from boundary import Boundary, circle

name, numbers = sys.argv[2], [float(text) for text in sys.argv[3:]]
degree = int(numbers[0]) if numbers else 1
sides = ["south", "east", "north", "west"]


def straight(boundary, curve, start, end, left, right):
    boundary.open(curve, degree, [a * (1 - k / degree) + b * (k / degree) for k in range(degree + 1) for a, b in zip(start, end)], left, right)


def block(boundary, corners, curves, face):
    for curve, start, end in zip(curves, corners, corners[1:] + corners[:1]):
        straight(boundary, curve, start, end, face, None)


def square(x, y, width):
    return [(x, y), (x + width, y), (x + width, y + width), (x, y + width)]


if name == "channel":
    domain = Boundary("fluid")
    block(domain, [(0, 0), (2, 0), (2, 1), (0, 1)], sides, "fluid")
elif name == "layers":
    y, domain = numbers[1], Boundary("below", "above")
    block(domain, [(0, y), (0, 0), (2, 0), (2, y)], ["west", "south", "east"], "below")
    block(domain, [(2, y), (2, 1), (0, 1), (0, y)], ["east", "north", "west"], "above")
    straight(domain, "interface", (2, y), (0, y), "below", "above")
elif name == "drop":
    domain = Boundary("drop", "fluid")
    domain.closed("interface", degree, circle((0, 0), numbers[2], degree, int(numbers[1])), "drop", "fluid")
    block(domain, square(-2, -2, 4), sides, "fluid")
elif name == "parts":
    domain = Boundary("one", "other")
    block(domain, square(0, 0, 1), sides, "one")
    block(domain, square(2, 0, 1), ["floor", "exit", "roof", "entry"], "other")
elif name == "corner":
    domain = Boundary("one", "other")
    block(domain, square(0, 0, 1), sides, "one")
    block(domain, square(1, 1, 1), ["floor", "exit", "roof", "entry"], "other")
elif name == "disk":
    domain = Boundary("fluid")
    domain.closed("rim", degree, circle((0, 0), 1, degree, int(numbers[1])), "fluid", None)
domain.write()
