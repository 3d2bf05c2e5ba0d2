#!/usr/bin/env bash
# measure passes meshes on as they are; its tables grow by a line a mesh in a series, a loop of processes and evolve alike.
. "${BASH_SOURCE%/*}/common.bash"

for tool in measure evolve advect bspline2mesh; do
  has_tool "$tool" || { echo "$tool is not built"; exit 0; }
done
# lines FILE N: the file has so many lines.
lines() { [ "$(wc -l <"$1")" = "$2" ] || fail "$1 has $(wc -l <"$1") lines, not $2: $(head -c 300 "$1")"; }

# A mesh with fields, one by face, that went through a tool already, and so is as the tools write it.
bspline2mesh --degree 3 --max-area 0.05 --field 'v=2*x+y,x-2*y' --field 'p@above=x*x' \
  "$SOURCE/samples/three-cells/cells.json" | advect --flow shear --dt 0.1 >mesh.json

# Meshes pass unchanged: alone, in a series, in a pipe.
cat disk.json mesh.json mesh.json >mixed.jsonl
run 0 measure --csv areas.csv --face '*:area,centre' mixed.jsonl
silent
same out mixed.jsonl
lines areas.csv 3 # the last one stands there already
measure --csv /dev/null --face '*:area' <mesh.json | advect --flow shear --dt 0.1 >by_pipe.json
advect --flow shear --dt 0.1 mesh.json >plain.json
same by_pipe.json plain.json

# One process with a series, and one for each mesh, make the same table.
options=(--face 'above:area,mean(v)' --curve 'ring=above:length,flux(v)' --at 'q=-3.9,1.7:p,v_x*2'
  --value 'twice=2*above_area' --line '-4.5,1.7:-3,1.7:5:v')
evolve --steps 4 --every 1 'advect --flow shear --dt 0.1' mesh.json >series.jsonl
run 0 measure --csv once.csv --lines-csv lines_once.csv "${options[@]}" series.jsonl -o /dev/null
while read -r mesh; do
  measure --csv many.csv --lines-csv lines_many.csv "${options[@]}" <<<"$mesh" >/dev/null || fail "one mesh alone"
done <series.jsonl
same once.csv many.csv
same lines_once.csv lines_many.csv
lines once.csv 6
lines lines_once.csv 26
run 0 measure --csv - "${options[@]}" --lines-csv lines_stdout.csv series.jsonl
same out once.csv
same lines_stdout.csv lines_once.csv

# evolve writes what its pipe writes: frames and tables.
step="advect --flow shear --dt 0.1 | measure --csv TABLE --face above:area,deformation,inclination --at '-3.9,1.7:v' | flipdelaunay"
run 0 evolve --steps 6 "${step/TABLE/evolve.csv}" mesh.json
mv out evolve.jsonl
lines evolve.csv 7
evolve --print-pipe --steps 6 "${step/TABLE/pipe.csv}" mesh.json >pipe.sh
bash pipe.sh >pipe.jsonl || fail "the pipe of evolve"
same evolve.jsonl pipe.jsonl
same evolve.csv pipe.csv

# A run that is taken up again at an earlier time ends with the table of a run without a break; so does one from the start.
evolve --steps 6 --every 3 -o whole.jsonl "${step/TABLE/whole.csv}" mesh.json
evolve --steps 5 --every 3 -o broken.jsonl "${step/TABLE/broken.csv}" mesh.json
head -n 2 broken.jsonl >cut.jsonl && mv cut.jsonl broken.jsonl # as if killed after step 5, the last frame being step 3
printf '0.7,0.' >>broken.csv                                    # while it wrote
evolve --resume --steps 6 --every 3 -o broken.jsonl "${step/TABLE/broken.csv}" mesh.json || fail "--resume"
same whole.jsonl broken.jsonl
same whole.csv broken.csv
evolve --steps 6 --every 3 -o whole.jsonl "${step/TABLE/whole.csv}" mesh.json
same whole.csv broken.csv

# A table that would be another one is left alone; so are tables when a mesh is refused.
cp once.csv kept.csv
run 2 measure --csv kept.csv --face 'above:area' mesh.json
says 'is no table of these columns'
no_output
same once.csv kept.csv
echo 'my notes' >notes.txt && cp notes.txt notes_kept.txt
run 2 measure --csv notes.txt --face '*:area' mesh.json
same notes.txt notes_kept.txt
run 3 measure --csv kept.csv --at '-3.9,1.7:sqrt(-1-x*x)' mesh.json
says 'sqrt(-1-x*x) is not finite at (-3.9, 1.7) and time 0.1'
run 3 measure --csv new.csv --face '*:area' tangled.json
[ ! -e new.csv ] || fail "a refused mesh left a table"
run 5 measure --csv nowhere/new.csv --face '*:area' mesh.json
[ ! -w /dev/full ] || run 5 measure --csv /dev/full --face '*:area' mesh.json

# Wrong calls, with a word on what is there.
refused() {
  local text=$1
  shift
  run 2 measure "$@" mesh.json
  says "$text"
  no_output
}
refused 'there is nothing to measure'
refused '--csv FILE is required' --face '*:area'
refused '--line needs --lines-csv' --line '0,0:1,1:3:v'
refused 'is "above" meant?' --csv new.csv --face 'abov:area'
refused 'there is no curve "abov"' --csv new.csv --curve 'abov:length'
refused 'is "area" meant?' --csv new.csv --face 'above:aera'
refused '"force" of a face' --csv new.csv --face 'above:force'
refused 'mean(FIELD)' --csv new.csv --face 'above:mean'
refused 'nothing in brackets' --csv new.csv --face 'above:area(p)'
refused 'not of an expression' --csv new.csv --face 'above:max(p*p)'
refused 'not of 1' --csv new.csv --face 'above:flux(p)'
refused 'no name that is known' --csv new.csv --at '0,0:pressure'
refused 'two columns would be called "above_area"' --csv new.csv --face 'above:area,area'
refused 'is "above_area" meant?' --csv new.csv --face 'above:area' --value 'q=above_aera'
refused 'a value has no place' --csv new.csv --face 'above:area' --value 'q=x'
refused 'should be X,Y' --csv new.csv --at '0:p'
refused 'is not a finite number' --csv new.csv --at '0,nan:p'
refused 'from 2 to 1000000' --lines-csv new.csv --line '0,0:1,1:1:p'
refused 'is wanted' --csv new.csv --face 'above'
refused 'an end of the list' --csv new.csv --face 'above:area,'
refused 'is given twice' --csv new.csv --face 'above:area' --set a=1 --set a=2
refused 'neither empty nor nearest' --csv new.csv --face 'above:area' --outside zero
refused 'both a table and INPUT' --csv mesh.json --face 'above:area'
refused 'both a table and --output' --csv new.csv -o new.csv --face 'above:area'
refused 'cannot go to one file' --csv new.csv --lines-csv new.csv --face 'above:area' --line '0,0:1,1:3:v'
cat >square_boundary.json <<'JSON'
{"format": "pliant-boundary", "version": 1, "vertices": [0, 0, 2, 0, 2, 1, 0, 1], "faces": [{"name": "channel"}],
 "curves": [
  {"name": "wall", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [0, 0, 2, 0], "start": 0, "end": 1, "left": 0, "right": null},
  {"name": "out", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [2, 0, 2, 1], "start": 1, "end": 2, "left": 0, "right": null},
  {"name": "wall", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [2, 1, 0, 1], "start": 2, "end": 3, "left": 0, "right": null},
  {"name": "in", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [0, 0, 0, 1], "start": 0, "end": 3, "left": null, "right": 0}]}
JSON
bspline2mesh --field 'u=y*(1-y),0' square_boundary.json >square.json
run 2 measure --csv new.csv --curve 'wall:area' square.json
says 'do not close'
# What enters counts positive, whichever way a curve runs; curves of one name count together.
run 0 measure --csv - --curve 'wall:length,flux(u)' --curve 'in:flux(u)' --curve 'out:flux(u),centre' --curve '*:flux(u)' square.json
python3 - <<'PYTHON' || fail "fluxes through the sides of a channel: $(cat out)"
import csv
row = {name: float(value) for name, value in next(csv.DictReader(open("out"))).items()}
wanted = {"wall_length": 4, "wall_flux_u": 0, "in_flux_u": 1 / 6, "out_flux_u": -1 / 6, "out_centre_x": 2, "out_centre_y": 0.5,
          "outer_flux_u": 0, "time": 0}
assert set(row) == set(wanted), set(row) ^ set(wanted)
assert all(abs(row[name] - wanted[name]) < 1e-14 for name in wanted), row
PYTHON
[ ! -e new.csv ] || fail "a wrong call left a table"
run 2 evolve --steps 1 'advect --flow shear --dt 0.1 | measure --csv - --face above:area' mesh.json
says '--csv - does nothing to a mesh'

# Through a curve between two faces counts what passes from its left to its right, and fields are seen from the left.
cat >drop_boundary.json <<'JSON'
{"format": "pliant-boundary", "version": 1, "vertices": [-3, -3, 3, -3, 3, 3, -3, 3], "faces": [{"name": "fluid"}, {"name": "drop"}],
 "curves": [
  {"name": "wall", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [-3, -3, 3, -3], "start": 0, "end": 1, "left": 0, "right": null},
  {"name": "wall", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [3, -3, 3, 3], "start": 1, "end": 2, "left": 0, "right": null},
  {"name": "wall", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [3, 3, -3, 3], "start": 2, "end": 3, "left": 0, "right": null},
  {"name": "wall", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [-3, 3, -3, -3], "start": 3, "end": 0, "left": 0, "right": null},
  {"name": "interface", "degree": 3, "closed": true, "knots": [0, 1, 2, 3, 4, 5, 6, 7, 8],
   "points": [1, 0, 0.7, 0.7, 0, 1, -0.7, 0.7, -1, 0, -0.7, -0.7, 0, -1, 0.7, -0.7], "left": 1, "right": 0}]}
JSON
bspline2mesh --degree 3 --max-turning 30 --field 'v=3*x+y,2*y-x' --field 'p@drop=5' --field 'p@fluid=1' drop_boundary.json >drop.json
run 0 measure --csv - --curve 'interface:flux(v),mean(p),area' --curve 'wall:flux(v)' --face 'drop:area,d=flux(v),integral(p),centre' \
  --face 'fluid:area,f=flux(v),max(p)' --face '*:m=mean(p),a=flux(v)' drop.json
python3 - <<'PYTHON' || fail "a drop in a box: $(cat out)"
import csv
row = {name: float(value) for name, value in next(csv.DictReader(open("out"))).items()}
drop, fluid = row["drop_area"], row["fluid_area"]
wanted = {"interface_area": drop, "interface_flux_v": 5 * drop, "interface_mean_p": 5, "wall_flux_v": -5 * 36, "d": 5 * drop,
          "drop_integral_p": 5 * drop, "drop_centre_x": 0, "drop_centre_y": 0, "f": 5 * fluid, "fluid_max_p": 1, "a": 5 * 36,
          "m": (5 * drop + fluid) / 36, "fluid_area": 36 - drop}
assert 2 < drop < 3.2
assert all(abs(row[name] - wanted[name]) < 1e-11 for name in wanted), (row, wanted)
PYTHON

# Forces are those that the mesh carries; parameters those of --set, before those of its problem.
python3 - <<'PYTHON'
import json
mesh = json.load(open("mesh.json"))
mesh["navierstokes"] = {"dt": 0.1, "forces": {"above": [0.25, -2]}}
mesh["problem"] = {"format": "pliant-problem", "version": 1, "parameters": {"U": 2, "twice": "2*U"}}
json.dump(mesh, open("force.json", "w"))
PYTHON
run 0 measure --csv - --curve 'o=above:force' --value 'cd=2*o_force_x/(U*twice)' force.json
[ "$(tail -n 1 out)" = "0.1,0.25,-2,0.0625" ] || fail "the force: $(tail -n 1 out)"
run 0 measure --csv - --curve 'o=above:force' --set U=1 --value 'cd=2*o_force_x/(U*twice)' force.json
[ "$(tail -n 1 out)" = "0.1,0.25,-2,0.25" ] || fail "the force with --set: $(tail -n 1 out)"
run 0 measure --csv - --curve 'above:force' mesh.json # nothing is solved yet
[ "$(tail -n 1 out)" = "0.1,," ] || fail "no forces: $(tail -n 1 out)"
run 3 measure --csv new.csv --curve 'below:force' force.json
says 'carries no force on curve "below"'
for forces in 3 '{"above": [1]}' '{"above": ["a", 2]}'; do
  python3 -c 'import json, sys
mesh = json.load(open("force.json")); mesh["navierstokes"]["forces"] = json.loads(sys.argv[1]); json.dump(mesh, open("bad.json", "w"))' "$forces"
  run 3 measure --csv new.csv --curve 'above:force' bad.json
  says '/navierstokes/forces'
done
# Names may hold what else separates the parts of a request.
sed 's/"name":"above"/"name":"n=1:above, old"/g' mesh.json >named.json
cmp -s named.json mesh.json && fail "no name was changed"
run 0 measure --csv - --face 'n=1:above, old:area' --curve 'o=n=1:above, old:length' named.json
[ "$(head -n 1 out)" = "time,n_1_above_old_area,o_length" ] || fail "names with signs: $(cat out)"
# --explain says what the columns are, and writes neither tables nor meshes.
run 0 measure --explain --csv new.csv --face 'above:area,mean(v)' --line '0,0:1,1:3:v' force.json
grep -qx 'above_mean_v_y: mean of v_y over face "above"' out || fail "--explain: $(cat out)"
[ ! -e new.csv ] || fail "--explain left a table"

finish
