#!/usr/bin/env bash
# What goes wrong is said, also with -q: the file, the place, what is wrong, and what would be right.
. "${BASH_SOURCE%/*}/common.bash"

# -q silences warnings and progress, no error and no failed condition.
for tool in "${mesh_filters[@]}"; do
  echo '{}' >bad.json
  run 3 filter "$tool" -q bad.json
  says "$tool: bad.json:1: frame 0: lacks the member \"format\""
  run 5 filter "$tool" -q no-such-file.json
  says 'no-such-file.json'
  run 2 filter "$tool" -q --no-such-option
  says 'there is no option --no-such-option'
done
if has_tool qualityreport; then
  run 1 qualityreport -q --fail-if 'triangles > 0' --fail-if 'triangles > 1e6' disk.json
  says 'qualityreport: disk.json: frame 0: triangles > 0: it is '
  (($(wc -l <err) == 1)) || fail "only the condition that failed is said: $(cat err)"
fi

# An unknown option, and one argument too many.
run 2 passthrough --max-aera 3 disk.json
says 'there is no option --max-aera; the nearest one is --max-area'
run 2 passthrough --maxturning=3 disk.json
says 'there is no option --maxturning; the nearest one is --max-turning'
run 2 passthrough --colour red disk.json
says 'there is no option --colour'
if grep -q nearest err; then fail "nothing is near to --colour: $(cat err)"; fi
run 2 passthrough disk.json three.json
says "one INPUT is read; 'three.json' is one argument too many"

# Files of another kind.
printf '<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg"><rect width="1" height="1"/></svg>\n' >drawing.svg
printf '$MeshFormat\n4.1 0 8\n$EndMeshFormat\n' >mesh.msh
cat >square.json <<'JSON'
{ "format": "pliant-boundary",
  "version": 1,
  "vertices": [0, 0],
  "faces": [{"name": "square"}],
  "curves": [
    { "name": "around", "degree": 1, "closed": false, "knots": [0, 0, 1, 2, 3, 4, 4],
      "points": [0, 0, 1, 0, 1, 1, 0, 1, 0, 0],
      "start": 0, "end": 0,
      "left": 0, "right": null }
  ] }
JSON
for tool in "${mesh_filters[@]}"; do
  run 3 filter "$tool" drawing.svg
  says "$tool: drawing.svg: this is an SVG drawing: import-svg makes a boundary of it, bspline2mesh a mesh of that"
  run 3 filter "$tool" mesh.msh
  says "$tool: mesh.msh: "  # read by every tool that reads meshes, and this one has none
  run 3 filter "$tool" square.json
  says 'this is a boundary, of which bspline2mesh makes a mesh (column 13)'
  run 3 filter "$tool" <(gzip -c square.json)
  says 'this is a boundary, of which bspline2mesh makes a mesh (column 13)'
  run 3 filter "$tool" <(gzip -c disk.json | head -c 100)
  says 'what gzip compressed ends early'
done
for tool in import-svg import-msh; do
  if ! has_tool $tool; then continue; fi
  run 3 $tool disk.json
  says "$tool: disk.json: this is a mesh, which "
  run 3 $tool square.json
  says "$tool: square.json: this is a boundary, of which bspline2mesh makes a mesh"
done
if has_tool import-msh; then
  run 3 import-msh drawing.svg
  says 'import-msh: drawing.svg: this is an SVG drawing: import-svg makes a boundary of it, bspline2mesh a mesh of that'
fi
if has_tool import-svg; then
  run 3 import-svg mesh.msh
  says 'import-svg: mesh.msh: this is a Gmsh MSH file: import-msh makes a mesh of it'
fi

# What a check finds after reading has a line and a column too.
if has_tool bspline2mesh; then
  run 0 bspline2mesh -q square.json
  run 3 bspline2mesh disk.json
  says 'this is a mesh, which '
  sed 's/"left": 0, "right": null/"left": null, "right": 0/' square.json >bad.json
  run 3 bspline2mesh bad.json
  grep -Eq '^bspline2mesh: bad.json:9: frame 0: /curves/0/(left|right): .*\(column (15|30)\)$' err ||
    fail "the line and column of what is exchanged: $(cat err)"
  sed 's/"end": 0/"end": 7/' square.json >bad.json
  run 3 bspline2mesh bad.json
  says 'bad.json:8: frame 0: /curves/0/end: is 7, but there are 1 vertices (column 26)'
  sed 's/"degree"/"degre"/' square.json >bad.json
  run 3 bspline2mesh bad.json
  says 'bad.json:6: frame 0: /curves/0: lacks the member "degree"; is "degre" meant to be it? (column 5)'
fi
# Another line of a series, and a mesh over many lines.
python3 - <<'PYTHON'
import json
mesh = json.load(open("disk.json"))
mesh["points"][6] += 0.25
open("bad.json", "w").write("\n\n" + json.dumps(mesh, indent=1))
PYTHON
run 3 passthrough bad.json
line=$(grep -oE '^passthrough: bad.json:[0-9]+' err | head -n 1 | grep -oE '[0-9]+$')
((${line:-0} > 3)) || fail "a structural fault names its own line: $(cat err)"
says '(column '

# A member that no tool knows is kept. A warning names it if its name is near to that of a missing member; in `criteria`
# every such member is named.
cat >misspell.py <<'PYTHON'
import json
import sys

mesh = json.load(open("disk.json"))
mesh["fields"] = [{"name": "u", "values": [0] * (len(mesh["points"]) // 2), "Components": 1, "byface": False,
                   "unit": "m"}]
mesh["boundary"]["cusp"] = mesh["boundary"].pop("cusps")
mesh["boundary"]["curves"][0]["removalError"] = mesh["boundary"]["curves"][0].pop("removal_error")
mesh["criteria"] = {"max_arae": 1, "min_angle": 10, "min_angles": 2, "colour": 7}
mesh["tiem"] = mesh.pop("time")
mesh["names"] = {"time": 1}
print(json.dumps(mesh, indent=1))
PYTHON
python3 misspell.py >bad.json
run 0 passthrough bad.json
for doubt in '/fields/0/Components: is kept, but not known; is "components" meant?' \
  '/fields/0/byface: is kept, but not known; is "by_face" meant?' \
  '/boundary/cusp: is kept, but not known; is "cusps" meant?' \
  '/boundary/curves/0/removalError: is kept, but not known; is "removal_error" meant?' \
  '/criteria/max_arae: is kept, but not known; is "max_area" meant?' \
  '/criteria/min_angles: is kept, but no criterion: nothing goes by it' \
  '/criteria/colour: is kept, but no criterion: nothing goes by it' \
  '/tiem: is kept, but not known; is "time" meant?'; do
  says ": frame 0: $doubt (column "
done
(($(wc -l <err) == 8)) || fail "these members and no other are told: $(cat err)"
grep -q '"tiem":' out || fail 'what is told is kept all the same'
line=$(grep -n '"max_arae"' bad.json | cut -d : -f 1)
says "passthrough: bad.json:$line: frame 0: /criteria/max_arae"
run 0 passthrough -q bad.json
[ ! -s err ] || fail "-q silences warnings: $(cat err)"
# A warning comes once a run, however many frames and curves have the member.
python3 - <<'PYTHON'
import json
mesh = json.load(open("bad.json"))
for name in "fields", "criteria", "tiem":
    del mesh[name]
del mesh["boundary"]["cusp"]
open("series.json", "w").write(3 * (json.dumps(mesh) + "\n"))
mesh["boundary"]["curves"][0]["removal_eror"] = 0
open("other.json", "w").write(json.dumps(mesh) + "\n")
PYTHON
run 0 passthrough series.json
(($(wc -l <err) == 1)) || fail "one line for all frames: $(cat err)"
run 0 passthrough other.json
(($(wc -l <err) == 2)) || fail "one line for each name: $(cat err)"
if has_tool bspline2mesh; then
  sed 's/"start"/"Start"/' square.json >bad.json
  run 3 bspline2mesh bad.json
  says 'an open curve should name the vertices start and end; is "Start" meant to be it? (column 5)'
  sed 's/"left"/"lefft"/' square.json >bad.json
  run 3 bspline2mesh bad.json
  says 'bspline2mesh: bad.json:9: frame 0: /curves/0/lefft: is kept, but not known; is "left" meant? (column 16)'
  python3 - <<'PYTHON'
import json
boundary = json.load(open("square.json"))
boundary["cupss"] = []
boundary["faces"][0] |= {"names": [], "colour": "red"}
boundary["curves"][0]["removal-error"] = 0
json.dump(boundary, open("bad.json", "w"))
PYTHON
  run 0 bspline2mesh bad.json
  says '/cupss: is kept, but not known; is "cusps" meant?'
  says '/curves/0/removal-error: is kept, but not known; is "removal_error" meant?'
  (($(grep -c 'is kept' err) == 2)) || fail "these members and no other are told: $(cat err)"
fi

if has_tool bspline2mesh && has_tool advect; then
  bspline2mesh -q --no-refine --field velocity=0,0 "$SOURCE/samples/examples/disk.json" >plain.json
  sed 's/"time":/"tiem":/' plain.json >flow.json
  run 0 advect --dt 0.01 --flow flow.json plain.json
  says 'advect: flow.json:1: frame 0: /tiem: is kept, but not known; is "time" meant?'
  run 0 advect -q --dt 0.01 --flow flow.json plain.json
  silent
  run 5 advect --dt 0.01 --flow MISSING.JSON plain.json
  says 'No such file'
fi

# A report must not overwrite what is read or written.
run 2 passthrough disk.json --report new.json -o ./new.json
says "--report and -o name the same file, 'new.json'"
[ ! -e new.json ] || fail "nothing should be written"
cp disk.json mine.json
ln -s mine.json alias.json
run 2 passthrough mine.json --report alias.json
says '--report and INPUT name the same file'
same mine.json disk.json

# The first tool of a pipe fails: the others say one line each, and a short one.
bash -c 'passthrough no-such-file.json | passthrough | passthrough --min-angle 20' >out 2>err
no_output
(($(wc -l <err) == 3)) || fail "one line a tool: $(cat err)"
(($(grep -c 'passthrough: standard input:1: the input is empty$' err) == 2)) || fail "short lines: $(cat err)"

# Time: steps that do not advance it, and steps that come to a round one.
if has_tool advect; then
  sample_mesh disk 2 1e6 >late.json
  run 4 advect --dt 1e-12 --until 1000001 --flow shear late.json
  says 'advect: late.json: frame 0: the step does not advance the time 1000000'
  no_output
  run 4 advect --dt 1e-12 --vx 0 --vy 0 late.json
  run 0 advect --dt 1e-9 --vx 0 --vy 0 late.json
  grep -q '"time":1000000.000000001,' out || fail "time after 1e-9: $(grep -o '"time":[^,]*' out)"
  run 0 advect --dt 1e-12 --until 1e6 --vx 0 --vy 0 late.json
  for dt in 0.05 0.1 0.001; do
    sample_mesh three 1 >moving.json
    for i in {1..100}; do advect --dt $dt --vx 0 --vy 0 moving.json -o moving.json; done
    time=$(grep -o '"time":[^,]*' moving.json)
    [ "$time" = "\"time\":$(python3 -c "print(f'{100 * $dt:.6g}')")" ] || fail "100 steps of $dt end at $time"
  done
  # A time with more digits is left as it is.
  sample_mesh disk 2 0.333333333333333 >third.json
  run 0 advect --dt 0.1 --vx 0 --vy 0 third.json
  grep -q "\"time\":$(python3 -c 'print(0.333333333333333 + 0.1)')," out || fail "$(grep -o '"time":[^,]*' out)"
fi
finish
