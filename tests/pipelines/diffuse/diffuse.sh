#!/usr/bin/env bash
# diffuse as a program: figures with closed forms, totals over many steps with all passes, evolve and pipe, refusals.
. "${BASH_SOURCE%/*}/../common.bash"
for tool in diffuse evolve advect flipdelaunay refine coarsen smoothcurves bspline2mesh; do
  has_tool "$tool" || { echo "$tool is not built" >&2; exit 77; }
done

# problem FILE SECTION: writes a problem document.
problem() { printf '{"format": "pliant-problem", "version": 1, "parameters": {"k": 0.01}, "diffuse": %s}\n' "$2" >"$1"; }
# value NAME: of the last line of the report r.
value() { tail -1 r | python3 -c 'import json, sys; print(json.load(sys.stdin)["values"][sys.argv[1]])' "$1"; }
# holds EXPRESSION: Python says that it is true.
holds() { python3 -c 'import math, sys; sys.exit(not eval(sys.argv[1]))' "$1" || fail "not true: $1"; }

bspline2mesh --max-area 0.02 "$SOURCE/samples/examples/disk.json" >mesh.json

# Poisson's equation: what the source sets free leaves through the rim, to rounding; the solution is near the formula.
problem poisson.json '{"field": "u", "materials": {"*": {"source": 1}}, "conditions": [{"curve": "*", "value": 0}]}'
run 0 diffuse --problem poisson.json --steady --report r --error '(1-x^2-y^2)/4' mesh.json
holds "abs($(value flux:rim) + $(qualityreport --format json mesh.json |
  python3 -c 'import json, sys; print(json.load(sys.stdin)["area"])')) < 1e-12"
holds "$(value error_l2) < 0.07 and $(value error_h1) < 0.01 and $(value residual) <= 1e-11"  # the disk is smaller
holds "0.2 < $(value max) < 0.25 and $(value min) > -1e-9"

# The mesh carries the problem; steps one by one are steps at once; --set changes the problem that is carried.
problem heat.json '{"field": "c", "materials": {"*": {"diffusivity": "k"}}, "initial": "exp(-20*((x-0.4)^2+y^2))"}'
run 0 diffuse --problem heat.json --dt 0.1 --steps 3 mesh.json
mv out three
run 0 bash -c 'diffuse --problem heat.json --dt 0.1 mesh.json | diffuse --dt 0.1 | diffuse --dt 0.1'
same out three
run 0 bash -c 'diffuse --problem heat.json --dt 0.1 --set k=2 mesh.json | diffuse --dt 0.1 --explain'
grep -qF 'parameter k = 2' out || fail "--set is not carried: $(cat out)"
run 0 diffuse --problem heat.json --dt 0.1 --steps 50 --until 0.25 mesh.json
grep -qF '"time":0.25' out || fail "--until with --steps"

# In a flow, with every pass: the same bytes as the pipe, and the total stays to rounding.
step="diffuse --problem heat.json --vx='-y*(1.2-x^2-y^2)' --vy='x*(1.2-x^2-y^2)' --dt 0.04 |
  flipdelaunay --projection conservative | refine | coarsen --projection conservative --region-change conserve |
  smoothcurves --projection conservative"
steps=${STEPS:-300}
run 0 evolve -q --steps "$steps" --every "$steps" --log log "$step" mesh.json
python3 - <<'END' || fail "the total drifts, or little was done"
import json
lines = [json.loads(line) for line in open("log")]
totals = [line["stages"][0]["values"]["total"] for line in lines]
done = {name: sum(stage["values"].get(name, 0) for line in lines for stage in line["stages"])
        for name in ("flips", "insertions", "removals")}
print("drift", max(abs(total / totals[0] - 1) for total in totals), done)
assert max(abs(total / totals[0] - 1) for total in totals) < 1e-12
assert done["flips"] > len(lines) and done["removals"] > 20 or len(lines) < 100
END
run 0 evolve -q --steps 8 --every 2 "$step" mesh.json
mv out by_evolve
run 0 evolve --print-pipe --steps 8 --every 2 "$step" mesh.json
mv out loop.sh
run 0 bash loop.sh
same out by_evolve
# A step that can only be taken in parts; a steady solution behind a stage that moves.
run 0 evolve -q --steps 2 "diffuse --problem heat.json --vx='4*sin(3*y)' --vy='4*sin(3*x)' --dt 0.2 | flipdelaunay | refine |
  coarsen | smoothcurves" mesh.json
run 0 evolve -q --steps 2 'advect --vx=-y --vy=x --dt 0.1 | diffuse --problem poisson.json --steady' mesh.json

# A slit, one face on both sides, sets free what its condition says: 1 for each length, of 0.4.
cat >slit.json <<'END'
{"format": "pliant-boundary", "version": 1, "vertices": [0, 0, 1, 0, 1, 1, 0, 1, 0.3, 0.5, 0.7, 0.5], "faces": [{"name": "f"}],
 "curves": [
 {"name": "wall", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [0, 0, 1, 0], "start": 0, "end": 1, "left": 0},
 {"name": "wall", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [1, 0, 1, 1], "start": 1, "end": 2, "left": 0},
 {"name": "wall", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [1, 1, 0, 1], "start": 2, "end": 3, "left": 0},
 {"name": "wall", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [0, 1, 0, 0], "start": 3, "end": 0, "left": 0},
 {"name": "slit", "degree": 1, "closed": false, "knots": [0, 0, 1, 1], "points": [0.3, 0.5, 0.7, 0.5], "start": 4, "end": 5,
  "left": 0, "right": 0}]}
END
problem wire.json '{"field": "u", "materials": {"*": {}}, "conditions": [{"curve": "wall", "value": 0}, {"curve": "slit", "flux": 1}]}'
bspline2mesh --max-area 0.02 slit.json >slit_mesh.json
run 0 diffuse --problem wire.json --steady --report r slit_mesh.json
holds "abs($(value flux:slit) - 0.4) < 1e-12 and abs($(value flux:wall) + 0.4) < 1e-12"

# Refusals: usage, problems that do not fit, elements, solvers.
run 2 diffuse --problem heat.json mesh.json
says '--dt is required'
run 2 diffuse --problem heat.json --dt 0.1 --method euler mesh.json
says 'a mesh at rest'
run 2 diffuse --problem heat.json --steady --dt 0.1 mesh.json
run 2 diffuse --problem heat.json --steady --steps 3 mesh.json
run 2 diffuse --problem heat.json --dt 0.1 --scheme bdf2 mesh.json
says 'sdirk2'
run 2 diffuse --problem heat.json --dt 0.1 --scheme crank-nicolson --form nonconservative mesh.json
run 2 diffuse --problem heat.json --dt 0.1 --set q=1 mesh.json
says 'k'
run 2 diffuse --problem heat.json --dt 0.1 --error c mesh.json
says 'fields'
run 2 diffuse --problem heat.json --dt 0.1 --error 'sin(' mesh.json
says '--error sin('
run 2 evolve --steps 1 'diffuse --problem heat.json --dt 0.1 --explain' mesh.json
run 3 diffuse --dt 0.1 mesh.json
says '--problem'
run 3 diffuse --problem heat.json --steady mesh.json
says '"value" or "robin"'
problem bad.json '{"field": "c", "materials": {"*": {"diffusivity": "0.1-x"}}, "initial": 1}'
run 3 diffuse --problem bad.json --dt 0.1 mesh.json
says 'bad.json:1: /diffuse/materials/*/diffusivity'
says 'positive'
says 'time 0'
no_output
problem bad.json '{"field": "c", "materials": {"*": {"source": "log(x)"}}, "initial": 1}'
run 3 diffuse --problem bad.json --dt 0.1 mesh.json
says 'finite'
problem bad.json '{"field": "c", "materials": {"*": {}}}'
run 3 diffuse --problem bad.json --dt 0.1 mesh.json
says 'no initial value'
run 3 diffuse --problem heat.json --dt 0.1 tangled.json
run 0 diffuse --problem heat.json --steps 0 mesh.json
grep -q '"name":"c"' out || fail "--steps 0 makes no field"
run 2 diffuse --problem heat.json --steps 0 --dt 0.1 mesh.json
problem stiff.json '{"field": "c", "materials": {"*": {"source": "-50*c"}}, "initial": "x", "conditions": []}'
run 4 diffuse --problem stiff.json --dt 1 mesh.json
says 'Picard'
no_output
finish
