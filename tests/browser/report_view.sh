#!/usr/bin/env bash
# The HTML report as it is seen: drawn on the first screenshot also where the machine is busy, fields and obstacles in
# their colours, addresses, light, dark and paper.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
# A square of two faces, side 2 around the origin: a field that is x, and one by face that is 0 left and 1 right.
python3 - <<'END' >square.json
import json

line = lambda name, a, b, p, q, left, right: {
    "name": name, "degree": 1, "closed": False, "knots": [0, 0, 1, 1], "points": [*p, *q], "start": a, "end": b,
    "left": left, "right": right}
at = [[-1, -1], [0, -1], [1, -1], [1, 1], [0, 1], [-1, 1]]
sides = [(0, 1, 0, None), (1, 2, 1, None), (2, 3, 1, None), (3, 4, 1, None), (4, 5, 0, None), (5, 0, 0, None),
         (1, 4, 0, 1)]
print(json.dumps({
    "format": "pliant-boundary", "version": 1, "vertices": sum(at, []), "faces": [{"name": "west"}, {"name": "east"}],
    "curves": [line(f"c{i}", a, b, at[a], at[b], *faces) for i, (a, b, *faces) in enumerate(sides)]}))
END
bspline2mesh --degree 2 --max-area 0.2 --field x=x --field side@west=0 --field side@east=1 square.json -o mesh.json
printf '%s\n' '<svg xmlns="http://www.w3.org/2000/svg"><rect x="2" y="-1" width="1" height="2"/></svg>' >wall.svg
python3 - <<'END' >series.jsonl
import json

mesh = json.load(open("mesh.json"))
mesh["history"] = [{"tool": "bspline2mesh", "version": "0.1", "options": ["--degree", "2"]}]
for frame in range(4):
    mesh["time"] = frame
    print(json.dumps(mesh))
END
qualityreport --format html --circle=-2,0,0.5 --svg wall.svg series.jsonl -o view.html
"$NODE" "$SOURCE/tests/browser/report_view.mjs" "$scratch"
