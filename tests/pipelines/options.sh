#!/usr/bin/env bash
# A wrong value of an option, or a document that lacks what the option needs, is refused with a message. Each message
# comes here once.
. "${BASH_SOURCE%/*}/common.bash"

# refuses STATUS TEXT COMMAND...: the command ends with this status, writes nothing, and says this.
refuses() {
  local status=$1 text=$2
  shift 2
  run "$status" "$@"
  no_output
  says "$text"
}
edit() { python3 -c "import json; m = json.load(open('disk.json')); $1; print(json.dumps(m))"; }

edit 'm["criteria"] = {"thin": "always"}' >bad.json
refuses 3 '/criteria/thin: expected "keep" or "refine"' passthrough bad.json
edit 'm["criteria"] = {"size": "x +"}' >bad.json
if has_tool refine; then
  refuses 2 'the expression is empty' refine --size '' disk.json
  refuses 2 '"=" would assign; to compare write "=="' refine --size 'x = 3' disk.json
  refuses 2 '"z" is no name that is known here (variables are x, y and t)' refine --size 'z' disk.json
  refuses 3 '/criteria/size: ' refine bad.json
  refuses 2 '--size: the wanted length is -1 at (' refine --size -1 disk.json
  refuses 2 '--size: the wanted length is no number at (' refine --size '0/0' disk.json
  edit 'm["criteria"] = {"size": "-2"}' >bad.json
  refuses 3 '/criteria/size: the wanted length is -2 at (' refine bad.json
fi

if has_tool advect; then
  to=(advect --dt 0.1)
  refuses 2 '--flow vortex:a: KEY=VALUE is wanted, not "a"' "${to[@]}" --flow vortex:a disk.json
  refuses 2 'is given twice' "${to[@]}" --flow vortex:period=1,period=2 disk.json
  refuses 2 '--flow: ' "${to[@]}" --flow vortices disk.json
  refuses 2 '--vx: ' "${to[@]}" --vx 'x +' --vy 0 disk.json
  refuses 2 '--vx and --vy go together' "${to[@]}" --vx 0 disk.json
  refuses 2 'exactly one of --vx with --vy, --flow and --velocity-field is wanted' "${to[@]}" disk.json
  refuses 3 '/fields: there is no field "w"; there is "u"' "${to[@]}" --velocity-field w disk.json
  refuses 3 '/fields/0/components: a velocity has 2 components, not 1' "${to[@]}" --velocity-field u disk.json
  if has_tool bspline2mesh; then
    sample_boundary annulus 2 >annulus.json
    face=$(python3 -c 'import json; print(json.load(open("annulus.json"))["faces"][0]["name"])')
    run 0 bspline2mesh -q --field "v@$face=x,y" annulus.json -o by-face.json
    refuses 3 '/by_face: a velocity must be continuous, not by face' "${to[@]}" --velocity-field v by-face.json
  fi
  still=(--vx 0 --vy 0)
  refuses 2 'there is no method "rk5"; there are euler, midpoint, rk4, dopri5' "${to[@]}" "${still[@]}" --method rk5 disk.json
  refuses 2 '--tol needs --method dopri5' "${to[@]}" "${still[@]}" --tol 1 disk.json
  refuses 2 '--tol' "${to[@]}" "${still[@]}" --method dopri5 --tol 0 disk.json
  refuses 2 '--substeps has no meaning with --method dopri5' "${to[@]}" "${still[@]}" --method dopri5 --substeps 2 disk.json
  refuses 2 '--method has no meaning with --velocity-field' "${to[@]}" --velocity-field u --method euler disk.json
  refuses 2 '--acceleration-field needs --velocity-field' "${to[@]}" "${still[@]}" --acceleration-field u disk.json
  refuses 2 '--outside needs --flow with a file' "${to[@]}" --flow shear --outside nearest disk.json
  refuses 2 '--flow-field needs --flow with a file' "${to[@]}" "${still[@]}" --flow-field u disk.json
  refuses 2 '"error" or "nearest" is wanted, not "far"' "${to[@]}" --flow disk.json --outside far disk.json
  refuses 2 'there is no flow "vortices"' "${to[@]}" --flow vortices disk.json
  refuses 4 'the tolerance 1e-40: at time ' "${to[@]}" --vx 'sin(y+t)' --vy x --method dopri5 --tol 1e-40 disk.json
  run 0 advect --dt 0.1 "${still[@]}" --field 'velocity=1,x' --field 'a=0,-y' disk.json -o flow.json
  refuses 3 '/fields: there is no field "w"; there is "u"' "${to[@]}" --velocity-field velocity --acceleration-field w flow.json
  refuses 3 '/fields/0/components: an acceleration has 2 components, not 1' \
    "${to[@]}" --velocity-field velocity --acceleration-field u flow.json
  run 0 "${to[@]}" --velocity-field velocity --acceleration-field a flow.json
  refuses 5 './nowhere.json: No such file' "${to[@]}" --flow ./nowhere.json disk.json
  refuses 3 'disk.json:1: frame 0: /fields: there is no field "velocity"; there is "u"' "${to[@]}" --flow disk.json flow.json
  refuses 3 '/fields/0/components: a velocity has 2 components, not 1' "${to[@]}" --flow disk.json --flow-field u flow.json
  cat flow.json flow.json >twice.jsonl
  refuses 3 'the times of a flow must increase: 0.1 comes after 0.1' "${to[@]}" --flow twice.jsonl disk.json
  : >empty.json
  refuses 3 'the input is empty' "${to[@]}" --flow empty.json disk.json
  refuses 4 'is outside the mesh of flow.json, by ' "${to[@]}" --flow flow.json disk.json
  run 0 "${to[@]}" --flow flow.json --outside nearest disk.json
  cp flow.json unnamed
  run 0 "${to[@]}" --flow unnamed --outside nearest disk.json
  { cat flow.json; sed 's/"time":0.1/"time":0.2/' flow.json; } >series.jsonl
  refuses 4 'time 0 is before the first frame of series.jsonl, at time 0.1' "${to[@]}" --flow series.jsonl disk.json
  # An unsafe step: refused, or taken by force, which is said.
  refuses 4 'disk.json: frame 0: ' advect --dt 9 --vx '9*y*y' --vy '-9*x*x*x' disk.json
  run 0 advect --dt 9 --vx '9*y*y' --vy '-9*x*x*x' --force disk.json
  says 'forced an unsafe step: '
fi
if has_tool bspline2mesh; then
  sample_boundary annulus 2 >annulus.json
  face=$(python3 -c 'import json; print(json.load(open("annulus.json"))["faces"][0]["name"])')
  for degree in 0 11 2.5 two; do
    refuses 2 '--degree: ' bspline2mesh --degree $degree annulus.json
  done
  refuses 2 "the field has 2 components on the other faces, not 1" \
    bspline2mesh -q --field v=x,y --field "v@$face=x" annulus.json
  refuses 2 '--field v: there is no face "nowhere"' bspline2mesh -q --field v@nowhere=x annulus.json
fi
if has_tool export-svg; then
  refuses 2 '--resolution 1: from 1e-12 to 0.01' export-svg --resolution 1 disk.json
fi
if has_tool qualityreport; then
  refuses 2 '--fail-if: ' qualityreport --fail-if 'invalid >' disk.json
  refuses 2 '--face: ' qualityreport --face nowhere disk.json
fi
if has_tool import-svg; then
  printf '<svg xmlns="http://www.w3.org/2000/svg"><rect width="1" height="1"/></svg>\n' >drawing.svg
  refuses 2 "--tolerance: '2' is not between 1e-12 and 1" import-svg --tolerance 2 drawing.svg
fi
refuses 5 'no-such-folder/report.json' passthrough --report no-such-folder/report.json disk.json
if [ -w /dev/full ]; then
  run 5 passthrough --report /dev/full disk.json
  says '/dev/full: '
fi
if has_tool smoothcurves && smoothcurves --help | grep -q -- --global; then
  for option in --split '--max-sweeps 3' '--measure control'; do
    refuses 2 "${option%% *} does not go with --global: it is for smoothing edge by edge" smoothcurves --global $option disk.json
  done
  refuses 2 '--good must be at most 1' smoothcurves --global --good 2 disk.json
fi

# Far from size 1 a document is worked on in another unit, which is said where lengths are.
python3 - <<'PYTHON'
import json

mesh = json.load(open("disk.json"))
for place in mesh, mesh["boundary"], *mesh["boundary"]["curves"]:
    for name in "points", "vertices":
        if name in place:
            place[name] = [2.0**400 * x for x in place[name]]
json.dump(mesh, open("huge.json", "w"))
mesh["points"][2 * mesh["constrained_edges"][0]["points"][0]] *= 1.5
json.dump(mesh, open("moved.json", "w"))
PYTHON
if has_tool flipdelaunay; then
  refuses 3 'has it (M4) (places and lengths are given in units of 2^401) (column ' flipdelaunay moved.json
fi
if has_tool advect; then
  refuses 3 '/fields: there is no field "w"; there is "u" (places and lengths are given in units of 2^401)' \
    advect --dt 0.1 --velocity-field w huge.json
  refuses 4 'no step was taken: the velocity is not finite on curve 0 ("cell") (places and lengths are given in units of 2^401)' \
    advect --dt 1e200 --vx 'x*y' --vy 'x*x' huge.json
fi
finish
