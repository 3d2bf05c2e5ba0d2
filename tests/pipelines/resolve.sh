#!/usr/bin/env bash
# Curves that cross: refused, or with --resolve meshed as the faces that a painter would see.
. "${BASH_SOURCE%/*}/common.bash"
for tool in bspline2mesh qualityreport; do
  has_tool "$tool" || exit 77
done

python3 - <<'PYTHON'
import json, math

def around(x, y, radius, corners, turns=1, start=0.0):
    angles = [start + 2 * math.pi * turns * i / corners for i in range(corners)]
    return [c for a in angles for c in (x + radius * math.cos(a), y + radius * math.sin(a))]

def write(path, curves, faces=None):
    names = [name for name, _, _ in curves]
    json.dump({"format": "pliant-boundary", "version": 1, "vertices": [], "from": "here",
               "faces": [{"name": name, "note": name.upper()} for name in names],
               "curves": [{"name": name, "degree": degree, "closed": True, "knots": list(range(len(points) // 2 + 1)),
                           "points": points, "start": None, "end": None, "left": i, "right": None, "removal_error": 0}
                          for i, (name, degree, points) in enumerate(curves)], "cusps": []}, open(path, "w"))

square = lambda x, y, side: [x + side, y, x + side, y + side, x, y + side, x, y]
write("squares.json", [("below", 1, square(0, 0, 2)), ("above", 1, square(1, 1, 2))])
write("hidden.json", [("small", 2, around(0, 0, 1, 8)), ("large", 2, around(0, 0, 2, 8))])
write("apart.json", [("one", 2, around(0, 0, 1, 8)), ("two", 3, around(3, 0, 1, 9))])
write("crossing.json", [("left", 2, around(0, 0, 1, 8)), ("right", 3, around(0.8, 0.2, 1, 9)),
                        ("star", 1, around(2.2, 0.4, 1, 5, turns=2)), ("again", 2, around(0, 0, 1, 8))])
write("stops.json", [("cusped", 3, [0, 0, 1, 1, 0, 0, 4, -3, 2, 4, -1, 3])])
PYTHON

sound() { qualityreport --fail-if 'invalid > 0' --fail-if 'overlaps > 0' --fail-if 'faults > 0' "$@"; }

for case in squares crossing; do
  run 3 bspline2mesh "$case.json"
done

run 0 bspline2mesh --resolve --report report.json squares.json
cp out mesh.json
run 0 sound --format json mesh.json
python3 - <<'PYTHON' || fail "the areas of two squares"
import json
report = json.load(open("out"))
areas = {face["name"]: face["area"] for face in report["faces"]}
assert abs(areas["below"] - 3) < 1e-14 and abs(areas["above"] - 4) < 1e-14, areas
done = json.loads(open("report.json").readline())["values"]
assert done["intersections"] == 2 and done["regions"] == 3 and done["slivers_collapsed"] == 0, done
boundary = json.load(open("mesh.json"))["boundary"]
assert boundary["from"] == "here" and [face["note"] for face in boundary["faces"]] == ["BELOW", "ABOVE"], boundary
PYTHON

run 0 bspline2mesh --resolve -v crossing.json
says "nothing is left of face 'left'"
mv out mesh.json
run 0 sound mesh.json

run 0 bspline2mesh --resolve -v hidden.json
says "nothing is left of face 'small'"
mv out mesh.json
run 0 sound mesh.json

# Curves that do not cross are meshed the same with the option and without.
run 0 bspline2mesh apart.json
cp out plain.json
run 0 bspline2mesh --resolve apart.json
same out plain.json

# A curve that stops inside, at a cusp, is meshed only with the option, which cuts it there.
run 3 bspline2mesh stops.json
says "curve 'cusped' (0) at parameter"
says 'derivative vanishes at'
run 0 bspline2mesh --resolve stops.json
mv out mesh.json
run 0 sound mesh.json
finish
