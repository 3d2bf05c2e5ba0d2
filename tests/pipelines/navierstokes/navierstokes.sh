#!/usr/bin/env bash
# navierstokes as a program: flows with closed forms, drops at rest, evolve and pipe, refusals.
. "${BASH_SOURCE%/*}/../common.bash"
for tool in navierstokes evolve flipdelaunay refine coarsen smoothcurves bspline2mesh qualityreport advect; do
  has_tool "$tool" || { echo "$tool is not built" >&2; exit 77; }
done
here=${BASH_SOURCE%/*}

# domain NAME NUMBERS...: a boundary document.
domain() { python3 "$SOURCE/tests/pipelines/navierstokes/domains.py" "$SOURCE" "$@"; }
# problem FILE SECTION [PARAMETERS]: writes a problem document.
problem() { printf '{"format": "pliant-problem", "version": 1, "parameters": {%s}, "navierstokes": {%s}}\n' "${3:-}" "$2" >"$1"; }
# holds EXPRESSION: Python says that it is true of v, the values of the last line of the report r.
holds() {
  tail -n 1 r | python3 -c 'import json, math, sys
v = json.load(sys.stdin)["values"]
sys.exit(not eval(sys.argv[1]))' "$1" || fail "not true: $1: $(tail -n 1 r)"
}
# exact BOUND [OPTIONS...]: the errors of the last report that begin with error_l2 are at most that.
exact() { holds "all(x <= $1 for k, x in v.items() if k.startswith('error_l2:')) and any(k.startswith('error_l2:') for k in v)"; }
fluid='"materials": {"*": {"viscosity": "mu"}}'

# Flows that the elements contain come out to rounding: between walls, through a channel with each kind of end, in layers.
for p in 2 3; do
  domain channel $p | bspline2mesh --max-area 0.05 >channel$p.json
  problem couette.json "$fluid, \"conditions\": [{\"curve\": \"*\", \"velocity\": [\"U*y\", 0]}]" '"U": 3, "mu": 0.02'
  run 0 navierstokes --problem couette.json --steady --report r --error velocity_x=3*y --error velocity_y=0 --error pressure=0 channel$p.json
  exact 1e-10
  holds 'abs(v["force_x:south"] - 2 * 0.02 * 3) < 1e-10 and abs(v["force_x:north"] + 2 * 0.02 * 3) < 1e-10'
  holds 'abs(v["flux:east"] - 1.5) < 1e-12 and abs(v["flux:west"] + 1.5) < 1e-12 and abs(v["dissipation"] - 2 * 0.02 * 9) < 1e-10'
  for ends in 'west|"velocity": ["4*y*(1-y)", 0]|east|"outflow": true' \
    'west|"traction": ["16*mu", "4*mu*(1-2*y)*(-1)"], "moves": false|east|"traction": [0, "4*mu*(1-2*y)"], "moves": false' \
    'west|"velocity": ["4*y*(1-y)", 0]|east|"traction": [0, "4*mu*(1-2*y)"], "moves": false'; do
    IFS='|' read -r one left two right <<<"$ends"
    problem poiseuille.json "$fluid, \"conditions\": [{\"curve\": \"$one\", $left}, {\"curve\": \"$two\", $right},
      {\"curve\": [\"north\", \"south\"], \"velocity\": [0, 0]}]" '"mu": 0.1'
    run 0 navierstokes --problem poiseuille.json --steady --report r --error 'velocity_x=4*y*(1-y)' --error velocity_y=0 \
      --error 'pressure=8*mu*(2-x)' channel$p.json
    exact 1e-10
  done
done
for p in 2 3; do
  # Two layers, one a thousand times as viscous, under a slope of the pressure of 1 and a lid: u is a parabola in each.
  domain layers $p 0.4 | bspline2mesh --max-area 0.05 >layers$p.json
  slope=$(python3 -c 'h, m, n, U = 0.4, 1.0, 1000.0, 0.01
# u = (a y - y^2/2)/m below, U + (b (1-y) - (1-y)^2/2)/n above; velocity and stress are continuous at h.
a = (U + (h * h / 2) / m + ((1 - h) - (1 - h) ** 2 / 2) / n) / (h / m + (1 - h) / n)
print(f"{a!r}, \"b\": {1 - a!r}")')
  u='y < 0.4 ? a*y - y^2/2 : U + (b*(1-y) - (1-y)^2/2)/1000'
  problem layers.json "\"materials\": {\"below\": {\"viscosity\": 1}, \"above\": {\"viscosity\": 1000}}, \"conditions\": [
    {\"curve\": \"west\", \"velocity\": [\"$u\", 0]}, {\"curve\": [\"south\", \"north\"], \"velocity\": [\"y > 0.5 ? U : 0\", 0]},
    {\"curve\": \"east\", \"outflow\": true}]" "\"U\": 0.01, \"a\": $slope"
  run 0 navierstokes --problem layers.json --steady --report r --error "velocity_x=$u" --error velocity_y=0 --error 'pressure=2-x' layers$p.json
  exact 1e-10

  # A film with a free surface runs down a slope, here as gravity that is inclined.
  problem film.json '"materials": {"*": {"viscosity": 0.5, "density": 2}}, "gravity": [0.25, -1], "conditions": [
    {"curve": "west", "velocity": ["y-y^2/2", 0]}, {"curve": "south", "velocity": [0, 0]}, {"curve": "north", "natural": true, "moves": false},
    {"curve": "east", "traction": ["-2*(1-y)", "0.5*(1-y)"], "moves": false}]'
  run 0 navierstokes --problem film.json --steady --report r --error 'velocity_x=y-y^2/2' --error velocity_y=0 --error 'pressure=2*(1-y)' channel$p.json
  exact 1e-10

  # Layers of two fluids at rest: the pressure alone carries them, also where the surface above is free, and tension acts.
  problem still.json '"materials": {"below": {"viscosity": 1, "density": 1000}, "above": {"viscosity": 0.1, "density": 1}}, "gravity": [0, -9.81],
    "surface_tension": {"interface": 0.7}, "conditions": [{"curve": "north", "natural": true}, {"curve": "*", "slip": true}]'
  run 0 navierstokes --problem still.json --dt 0.1 --steps 3 --report r --error velocity_x=0 --error velocity_y=0 \
    --error 'pressure=9.81*(y < 0.4 ? 0.6 + 1000*(0.4-y) : 1-y)' layers$p.json
  exact 1e-9
  holds 'v["max_speed"] < 1e-11 and v["max_displacement"] < 1e-12 and v["time"] > 0.29'

  # A drop at rest stays so to rounding, and its tension over its radius is what the pressure jumps by. With a continuous pressure neither.
  domain drop $p 24 1 | bspline2mesh --max-area 0.2 >drop$p.json
  tension='"materials": {"*": {"viscosity": 1}}, "surface_tension": {"interface": 2}, "conditions": [{"curve": "*", "velocity": [0, 0]}]'
  problem drop.json "$tension"
  run 0 navierstokes --problem drop.json --dt 0.1 --steps 3 --report r drop$p.json
  holds 'v["max_speed"] <= 1e-11 and abs(v["max_pressure"] - v["min_pressure"] - 2) < 2e-6'
  problem drop.json "$tension, \"pressure\": \"continuous\""
  run 0 navierstokes --problem drop.json --dt 0.1 --steps 3 --report r drop$p.json
  holds 'v["max_speed"] > 1e-4 and abs(v["max_pressure"] - v["min_pressure"] - 2) > 1e-3'
done

# What turns like a rigid body has twice its angular velocity as vorticity, everywhere.
for p in 2 3; do
  domain disk $p 16 | bspline2mesh --max-area 0.2 >disk$p.json
  problem rigid.json '"materials": {"*": {"viscosity": 0.3, "density": 0}}, "conditions": [{"curve": "rim", "velocity": ["-w*y", "w*x"]}]' '"w": 1.5'
  run 0 navierstokes --problem rigid.json --steady --vorticity --report r --error velocity_x=-w*y --error velocity_y=w*x disk$p.json
  exact 1e-11
  qualityreport --format json out | python3 -c 'import json, sys
fields = {f["name"]: f for f in json.load(sys.stdin)["fields"]}
sys.exit(not (abs(fields["vorticity"]["min"][0] - 3) < 1e-9 and abs(fields["vorticity"]["max"][0] - 3) < 1e-9))' || fail "the vorticity of a rotation at degree $p"
done

# Steps one by one are steps at once, on a mesh at rest and on one that moves; the mesh carries the problem and what --set changes.
problem shear.json '"materials": {"drop": {"viscosity": "5*mu", "density": 2}, "*": {"viscosity": "mu"}}, "surface_tension": {"interface": "g"},
  "conditions": [{"curve": "*", "velocity": ["G*y", 0]}], "initial": ["G*y", 0]' '"G": 1, "mu": 0.1, "g": 0.2'
for way in "--mesh-velocity fixed" "--mesh-velocity harmonic" "--mesh-velocity blend --scheme euler" "--mesh-velocity lagrangian"; do
  run 0 navierstokes --problem shear.json --dt 0.03 --steps 3 $way drop2.json
  mv out three
  run 0 bash -c "navierstokes --problem shear.json --dt 0.03 $way drop2.json | navierstokes --dt 0.03 $way | navierstokes --dt 0.03 $way"
  same out three
done
run 0 bash -c 'navierstokes --problem shear.json --dt 0.05 --set mu=2 drop2.json >changed; navierstokes --explain changed'
grep -qF 'parameter mu = 2' out || fail "--set is not carried: $(cat out)"
for words in "face 'drop' (0): density 2; viscosity 5*mu (mu = 2)" 'velocity is continuous (default); the mesh follows the flow (default); surface tension g' \
  'by face' 'the mesh does not move (default)' 'has a velocity' 'unknowns: ' 'viscous terms as stress'; do
  grep -qF "$words" out || fail "--explain does not say '$words': $(cat out)"
done
run 0 navierstokes --problem shear.json --dt 0.1 --steps 50 --until 0.25 --report r drop2.json
holds 'v["time"] == 0.25 and abs(v["dt"] - 0.25) < 1e-15 and v["solves"] == 4'  # one of them makes the velocity
python3 -c 'import json
memory = json.load(open("out"))["navierstokes"]
forces = memory["forces"]
assert abs(memory["dt"] - 0.05) < 1e-15 and set(forces) == {"south", "east", "north", "west"}, memory' || fail "the member navierstokes"
mv out later
run 0 navierstokes --dt 0.1 --until 0.25 later
same out later

# A step is whole, or limited, or refused; areas are kept to rounding where that is wanted.
run 4 navierstokes --problem shear.json --dt 40 drop2.json
says 'not proved safe'
no_output
run 0 navierstokes --problem shear.json --dt 40 --limit --report r drop2.json
holds '0 < v["dt"] < 40 and v["time"] == v["dt"]'
area() { qualityreport --format json "$1" | python3 -c 'import json, sys; print(repr(json.load(sys.stdin)["faces"][0]["area"]))'; }
run 0 navierstokes --problem shear.json --dt 0.1 --steps 5 --keep-area drop2.json
[ "$(python3 -c "print(abs($(area out) / $(area drop2.json) - 1) < 1e-13)")" = True ] || fail "--keep-area: $(area out) $(area drop2.json)"
run 0 navierstokes --problem shear.json --dt 0.1 --steps 5 drop2.json
[ "$(python3 -c "print(1e-12 < abs($(area out) / $(area drop2.json) - 1) < 1e-2)")" = True ] || fail "the area without --keep-area: $(area out)"

# evolve is the pipe, byte for byte, with all passes and their frames.
step='navierstokes --problem shear.json --dt 0.1 | flipdelaunay | refine | coarsen | smoothcurves'
run 0 evolve -q --steps 6 --every 2 --log log "$step" drop2.json
mv out by_evolve
python3 -c 'import json
lines = [json.loads(line) for line in open("log")]
assert sum(stage["values"].get("flips", 0) for line in lines for stage in line["stages"]) > 5, "few flips"
assert all(json.loads(line)["navierstokes"]["dt"] > 0 for line in list(open("by_evolve"))[1:])' || fail "little was done"
run 0 evolve --print-pipe --steps 6 --every 2 "$step" drop2.json
mv out loop.sh
run 0 bash loop.sh
same out by_evolve
# A step that can only be taken in parts.
run 0 evolve -q --steps 2 --log log "${step/dt 0.1/dt 0.8}" drop2.json
python3 -c 'import json
lines = [json.loads(line) for line in open("log")]
assert len(lines) > 2 and lines[-1]["time"] == 1.6 and max(abs(line["stages"][0]["values"]["residual"]) for line in lines) < 1e-9' || fail "a step in parts"

# Usage.
refused() { local status=$1 word=$2; shift 2; run "$status" "$@"; says "$word"; no_output; }
mesh=drop2.json given="--problem shear.json"
while IFS='|' read -r word options; do
  refused 2 "$word" bash -c "navierstokes $given $options $mesh"
done <<'CASES'
--dt is required|
--dt|--dt 0
--dt|--dt=-1
--dt|--dt nan
--steady|--steady --dt 0.1
--steady|--steady --steps 3
--steady|--steady --limit
--steady|--steady --scheme bdf2
--steady|--steady --mesh-velocity fixed
--steps 0|--steps 0 --dt 0.1
--steps|--steps=-1 --dt 0.1
--steps|--steps 1.5 --dt 0.1
bdf2 and euler|--dt 0.1 --scheme sdirk2
harmonic|--dt 0.1 --mesh-velocity still
--error|--dt 0.1 --error velocity=1
--error|--dt 0.1 --error velocity_x
fields|--dt 0.1 --error velocity_x=velocity_x
"G", "mu" and "g"|--dt 0.1 --set q=1
--set|--dt 0.1 --set mu=
--gap|--dt 0.1 --gap hold
--no-such|--dt 0.1 --no-such
CASES
refused 2 '--explain' evolve --steps 1 "navierstokes $given --dt 0.1 --explain" $mesh
refused 2 'moves time on' evolve --steps 1 "advect --vx 1 --vy 0 --dt 0.1 | navierstokes $given --dt 0.1" $mesh
refused 3 '--problem' navierstokes --dt 0.1 $mesh

# Problems that do not fit: SECTION|WORD|WORD ..., with the place of what is wrong.
wall='"conditions": [{"curve": "*", "velocity": [0, 0]}]'
while IFS='|' read -r section words; do
  problem bad.json "$section" '"mu": 1'
  run 3 navierstokes --problem bad.json --dt 0.1 $mesh
  no_output
  says 'bad.json:1'
  while [ -n "$words" ]; do says "${words%%|*}"; words=${words#"${words%%|*}"}; words=${words#|}; done
done <<CASES
$fluid, "conditions": [{"curve": ["north", "west"], "velocity": [0, 0]}]|"south" and "east"|outer boundary
$fluid|"south"|outer boundary
$wall|materials
"materials": {"drop": {"viscosity": 1}}, $wall|fluid
"materials": {"*": {"density": 1}}, $wall|viscosity
"materials": {"*": {"viscosity": 0}}, $wall|/navierstokes/materials/*/viscosity|should be above zero
"materials": {"*": {"viscosity": 1, "density": -1}}, $wall|density
"materials": {"*": {"viscosity": "0.1-x"}}, $wall|/navierstokes/materials/*/viscosity|positive|time 0
"materials": {"*": {"viscosity": "log(x)"}}, $wall|viscosity|time 0
"materials": {"*": {"viscosity": 1, "density": "x"}}, $wall|density|at least 0
"materials": {"*": {"viscosity": "nothing"}}, $wall|nothing
$fluid, $wall, "surface_tension": {"interface": -1}|/navierstokes/surface_tension/interface
$fluid, $wall, "surface_tension": {"interface": "x"}|surface_tension/interface|at least 0
$fluid, $wall, "surface_tension": {"*": 1}|surface_tension
$fluid, $wall, "surface_tension": {"membrane": 1}|membrane
$fluid, $wall, "gravity": [0]|gravity
$fluid, $wall, "gravity": ["1/0", 0]|gravity
$fluid, $wall, "force": ["sqrt(x)", 0]|force
$fluid, $wall, "initial": ["velocity_x", 0]|initial/0
$fluid, $wall, "initial": ["sqrt(x)", 0]|initial/0
$fluid, $wall, "pressure": "smooth"|pressure|continuous
$fluid, $wall, "pressures": "continuous"|pressures
$fluid, "conditions": [{"curve": "*", "velocity": ["log(x)", 0]}]|conditions/0/velocity/0
$fluid, "conditions": [{"curve": "*", "velocity": [0]}]|conditions/0/velocity
$fluid, "conditions": [{"curve": "*", "velocity": [0, 0], "slip": true}]|conditions/0
$fluid, "conditions": [{"curve": "*", "slip": false}]|conditions/0/slip
$fluid, "conditions": [{"curve": "*"}]|conditions/0
$fluid, "conditions": [{"curve": "*", "velocity": [0, 0]}, {"curve": "interface", "natural": true}]|interface|outer boundary
$fluid, "conditions": [{"curve": "*", "velocity": [0, 0]}, {"curve": "interface", "outflow": true}]|interface|outer boundary
$fluid, "conditions": [{"curve": "*", "outflow": true, "moves": true}]|conditions/0/moves
$fluid, "conditions": [{"curve": ["south", "south"], "velocity": [0, 0]}, {"curve": "*", "slip": true}]|south
$fluid, "conditions": [{"curve": "lid", "velocity": [0, 0]}, {"curve": "*", "slip": true}]|lid
$fluid, "conditions": [{"curve": "*", "velocity": ["x", "y"]}]|more leaves than enters|31.9|outflow
$fluid, "conditions": [{"curve": "*", "velocity": ["-x*t", 0]}], "initial": [0, 0]|enters|time 0.1
CASES

# Meshes that do not fit: of degree 1, tangled, with fields or a member that no step has left.
sample_mesh disk 1 >straight.json
problem round.json "\"materials\": {\"*\": {\"viscosity\": 1}}, $wall"
for options in "--dt 0.1" "--steady" "--steps 0"; do
  refused 3 'degree 2 or more' navierstokes --problem round.json $options straight.json
  refused 3 'smoothcurves' navierstokes --problem round.json $options tangled.json
done
# changed PYTHON: the mesh as changed by a statement about m, c being its count of points.
changed() { python3 -c 'import json, sys
m = json.load(open("two.json")); c = len(m["points"]) // 2
def field(name, components): m["fields"] = [f for f in m["fields"] if f["name"] != name] + [
  {"name": name, "components": components, "by_face": False, "values": [0] * (components * c)}]
exec(sys.argv[1]); json.dump(m, sys.stdout)' "$1" >changed.json; }
run 0 navierstokes --problem shear.json --dt 0.1 --steps 2 drop2.json
mv out two.json
for name in velocity acceleration mesh_velocity; do
  for components in 1 3; do
    for way in harmonic fixed; do
      changed "field('$name', $components)"
      refused 3 "\"$name\" has $components component" navierstokes --dt 0.1 --mesh-velocity $way changed.json
    done
  done
  changed "field('$name', 2); n = len(m['triangles']) // 6; faces = m['triangle_faces']; f = m['fields'][-1]; f['by_face'] = True
f['places'] = [x for pair in sorted({(p, faces[t]) for t in range(n) for p in m['triangles'][6 * t:6 * t + 6]}) for x in pair]
f['values'] = [0] * len(f['places'])"
  refused 3 'continuous' navierstokes --dt 0.1 changed.json
done
while IFS='|' read -r value word; do
  changed "m['navierstokes'] = $value"
  refused 3 "/navierstokes$word" navierstokes --dt 0.1 changed.json
done <<'CASES'
[]|
"dt"|
{"dt": 0}|/dt
{"dt": -1}|/dt
{"dt": "0.1"}|/dt
{"dt": None}|/dt
{"dt": 0.1, "forces": []}|/forces
{"dt": 0.1, "forces": {"south": 1}}|/forces/south
{"dt": 0.1, "forces": {"south": [1, 2, 3]}}|/forces/south
CASES
# Without the member, and with one of another program beside it, the step is one of euler.
changed "del m['navierstokes']; m['other'] = {'dt': 0}"
run 0 navierstokes --dt 0.1 --report r changed.json
holds 'v["euler_steps"] == 1'
grep -q '"other":{"dt":0}' out || fail "an unknown member is lost"
run 0 navierstokes --dt 0.1 --report r two.json
holds 'v["euler_steps"] == 0'
run 0 navierstokes --dt 0.3 --report r two.json
holds 'v["euler_steps"] == 1'

# Two parts, apart or with a point in common, of which one is enclosed: its pressure has the mean 0, the other's is that of its end.
for shape in parts corner; do
  domain $shape 2 | bspline2mesh --max-area 0.05 >$shape.json
  pipe='{"curve": ["north", "south"], "velocity": [0, 0]}, {"curve": "west", "velocity": ["4*y*(1-y)", 0]}, {"curve": "east", "outflow": true}'
  box='{"curve": ["floor", "exit", "roof", "entry"], "velocity": [0, 0]}'
  for fluids in '"*": {"viscosity": 1}' '"one": {"viscosity": 1}, "other": {"viscosity": 3}'; do
    problem pair.json "\"gravity\": [\"x > 1.5 || y > 1 ? 1 : 0\", 0], \"materials\": {$fluids}, \"conditions\": [$pipe, $box]"
    run 0 navierstokes --problem pair.json --steady --report r $shape.json
    holds 'abs(v["max_pressure"] - 8) < 1e-10 and abs(v["min_pressure"] + 0.5) < 1e-10 and abs(v["flux:east"] - 2 / 3) < 1e-12'
  done
  problem pair.json "$fluid, \"conditions\": [$pipe, ${box/\[0, 0\]/[\"x\", 0]}]" '"mu": 1'
  refused 3 '"other"' navierstokes --problem pair.json --steady $shape.json
  says 'more leaves'
done
# A wall inside the fluid parts pressures, whatever flows on its sides, and nothing may pass it on balance.
channel='{"curve": ["north", "south"], "velocity": [0, 0]}, {"curve": "west", "velocity": ["4-y^2", 0]}, {"curve": "east", "outflow": true}'
for fluids in '"*": {"viscosity": 2}' '"drop": {"viscosity": 1}, "*": {"viscosity": 2}'; do
  problem inner.json "\"materials\": {$fluids}, \"conditions\": [$channel, {\"curve\": \"interface\", \"velocity\": [0, 0]}]"
  run 0 navierstokes --problem inner.json --steady --report r drop2.json
  holds '730 < v["force_x:interface"] < 745'
  problem inner.json "\"materials\": {$fluids}, \"conditions\": [$channel, {\"curve\": \"interface\", \"velocity\": [\"x\", 0]}]"
  refused 3 '"drop"' navierstokes --problem inner.json --steady drop2.json
  says 'more leaves'
done

# A driven cavity too coarse for its Reynolds number: Newton's method gives up, with figures, in bounded time.
domain channel 2 | bspline2mesh --max-area 0.1 >cavity.json
lid='"conditions": [{"curve": "north", "velocity": ["(x*(2-x))^2", 0]}, {"curve": "*", "velocity": [0, 0]}]'
problem driven.json "$fluid, $lid" '"mu": 0.01'
run 0 navierstokes --problem driven.json --steady cavity.json
refused 4 "Newton's method does not converge" timeout 60 navierstokes --problem driven.json --steady --set mu=1e-7 cavity.json
says 'of the convection'
finish
