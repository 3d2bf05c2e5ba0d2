#!/usr/bin/env bash
# evolve gives the bytes of the shell loop that --print-pipe prints: other degrees, domains, fields, options, schedules.
. "${BASH_SOURCE%/*}/../common.bash"
for tool in evolve advect flipdelaunay refine coarsen smoothcurves bspline2mesh; do
  has_tool "$tool" || { echo "$tool is not built" >&2; exit 77; }
done

# equal STEP START OPTIONS...: both give the same frames.
equal() {
  local step=$1 start=$2
  shift 2
  run 0 evolve -q "$@" "$step" "$start"
  mv out by_evolve
  run 0 evolve --print-pipe "$@" "$step" "$start"
  mv out loop.sh
  run 0 bash loop.sh
  cmp -s out by_evolve || fail "not the frames of the pipe: evolve $* '$step' $start ($(cmp out by_evolve 2>&1))"
}
frames() { [ "$(wc -l <by_evolve)" = "$1" ] || fail "$(wc -l <by_evolve) frames, not $1"; }

bare='advect --flow vortex:period=2 --dt 0.02 | flipdelaunay | refine | coarsen | smoothcurves'
options='advect --vx "0.3*sin(y)*cos(t)" --vy "0.3*sin(2*x) + 0.1*t" --dt 0.05 --substeps 2 --keep-area |
  flipdelaunay --projection l2 | refine --max-turning 35 --projection conservative |
  coarsen --tolerance 1e-3 --step-tolerance 5e-4 --region-change conserve --keep-area |
  smoothcurves --max-distortion 1.01 --vertices --flips --split'
carried='advect --velocity-field v --dt 0.05 | flipdelaunay | refine | coarsen | smoothcurves'
steps=${STEPS:-50}
cells=$SOURCE/samples/three-cells/cells.json

for degree in 1 2 3 4; do
  if ((degree > 1)); then
    bspline2mesh --degree "$degree" --max-turning 40 --field 'u=sin(3*x)+y' --field 'v=0.2*sin(y),0.1*cos(x)' \
      "$cells" >cells.json
    face=$(grep -o '"faces":\[{"name":"[^"]*"' cells.json | sed 's/.*"name":"//; s/"$//')
    refine --max-area 100 cells.json | advect --dt 1e-9 --vx 0 --vy 0 --field "p@$face=x*x-y" >fields.json
  else
    sample_mesh three 1 | advect --dt 1e-9 --vx 0 --vy 0 --field 'v=0.2*sin(y),0.1*cos(x)' >fields.json
  fi
  grep -q by_face fields.json || ((degree == 1)) || fail "no field by face"
  equal "$bare" fields.json --steps "$steps" --every 7
  frames $((2 + steps / 7))
  equal "$options" fields.json --steps 12
  equal "$carried" fields.json --until 0.61 --at 0.1,0.333333
done

# Another domain; one stage alone; a step that can only be taken in parts; the mover in the middle; a start at an odd time.
equal "$bare" disk.json --steps "$steps" --every 50
equal 'advect --vx=-y --vy=x --dt 0.1' disk.json --steps 10 --every 1
frames 11
bspline2mesh --max-turning 40 "$cells" >cells.json
equal 'advect --flow cylinder --dt 2.9 | flipdelaunay | refine | coarsen | smoothcurves' cells.json --steps 3 --every 1
equal 'flipdelaunay | refine | advect --flow cylinder --dt 0.3 --limit | coarsen' cells.json --until 1
sample_mesh disk 3 0.123456789012345678 >odd.json
equal "$bare" odd.json --steps 9 --every 2
equal "$bare" odd.json --until 0.2
# A goal that a whole step misses by some bits only, and a frame within the slack of a step.
equal 'advect --vx=1 --vy=0 --dt 0.1' disk.json --until 0.3 --at 0.2
frames 3
equal 'advect --vx=1 --vy=0 --dt 0.1' disk.json --until 0.3 --at 0.08,0.08000000000000001,0.2000000000001
equal 'advect --vx=1 --vy=0 --dt 5' disk.json --until 1 --at 1,0.9999999999
# An input that no tool has written: spaces, members in another order.
python3 -c 'import json, sys; d = json.load(sys.stdin); d = {"meta": {"time": 7}, **d}; json.dump(d, sys.stdout)' <disk.json >./-spaced.json
equal 'advect --vx=1 --vy=0 --dt 0.1' ./-spaced.json --steps 2 --every 1
equal 'advect --vx=1 --vy=0 --dt 0.05' disk.json --steps 100 --every 20
grep -q '"time":5,' by_evolve || fail "100 steps of 0.05 do not end at 5"

# Numbered files.
evolve -q --steps 4 --every 2 --frames 'a/%03d.json' "$bare" disk.json || fail "numbered files"
mkdir b
evolve --print-pipe --steps 4 --every 2 --frames 'b/%03d.json' "$bare" disk.json >loop.sh && bash loop.sh
for frame in 000 001 002; do same "a/$frame.json" "b/$frame.json"; done
[ ! -e a/003.json ] || fail "one frame too many"
finish
