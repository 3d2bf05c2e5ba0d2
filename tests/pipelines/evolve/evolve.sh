#!/usr/bin/env bash
# evolve from the outside: wrong steps, where frames go, what stops a simulation, and what is left then.
. "${BASH_SOURCE%/*}/../common.bash"
for tool in evolve advect flipdelaunay bspline2mesh; do
  has_tool "$tool" || { echo "$tool is not built" >&2; exit 77; }
done
step='advect --vx=1 --vy=0 --dt 0.1 | flipdelaunay'

# What a shell user gets wrong, each with its place.
refuses() { # refuses STEP TEXT...: status 2, and each text in the message
  run 2 evolve --steps 1 "$1" disk.json
  no_output
  local text
  for text in "${@:2}"; do says "$text"; done
}
refuses 'advect --vx 1 --vy 0 --dt $DT' 'STEP, line 1, column 27' expanded
refuses 'advect --vx 1 --vy 0 --dt 1 | flip' 'line 1, column 31' "there is no stage 'flip'" flipdelaunay
refuses 'advect --vx 1 --vy 0 --dt 1 | qualityreport' "no stage 'qualityreport'"
refuses 'advect --vx 1 --vy 0 --dt 1 | evolve' "no stage 'evolve'"
refuses 'advect --vx 1 --vy 0 --dt 1 | flipdelaunay -o out.json' 'column 44' 'no option -o' 'evolve writes the frames'
refuses 'advect --vx 1 --vy 0 --dt 1 --report r.json' 'column 29' 'no option --report' '--log'
refuses 'advect --vx 1 --vy 0 --dt 1 -v' 'column 29' 'before STEP'
refuses 'advect --vx 1 --vy 0 --dt 1 mesh.json' 'column 29' 'reads no INPUT'
refuses 'advect --vx 1 --vy 0 --dt 1 -' 'reads no INPUT'
refuses 'advect --vx 1 --vy 0 --dt=-1' 'column 22' '--dt'
refuses $'advect --vx 1 --vy 0 --dt 1 |\n refine --max-aera 1' 'line 2, column 9' 'nearest one is --max-area'
refuses 'advect --vx x+ --vy 0 --dt 1' 'column 8' '--vx'
refuses 'advect --vx 1 --vy 0' 'line 1, column 1' '--dt is required'
refuses 'advect --help' 'gives no help'
refuses 'advect --flow help' 'gives no help'
refuses 'advect --vx 1 --vy 0 --dt 1 --until 3' 'column 1' '--until belongs to evolve'
refuses 'flipdelaunay | refine' 'no stage moves time on' advect
refuses 'advect --vx 1 --vy 0 --dt 1 | advect --vx 1 --vy 0 --dt 1' 'column 31' 'second stage that moves time'
refuses 'smoothcurves --global | advect --vx 1 --vy 0 --dt 1' '--global'
refuses 'advect --vx 1 --vy 0 --dt 1 > o.json' 'redirected'
refuses 'advect --vx 1 --vy 0 --dt 1; refine' 'joined by |'
refuses 'advect --vx 1 --vy 0 --dt 1 |' 'column 29' 'no command follows'
refuses '' 'empty'

# Wrong options.
wrong() { # wrong TEXT ARGUMENTS...
  run 2 evolve "${@:2}"
  says "$1"
  no_output
}
wrong 'where to end is not said' "$step" disk.json
wrong 'there is no STEP' --steps 1
wrong 'exclude each other' --steps 1 --every 1 --at 1 "$step" disk.json
wrong 'lies beyond --until' --until 1 --at 0.5,2 "$step" disk.json
wrong "--at: 'x'" --until 1 --at x "$step" disk.json
wrong "--every: '0'" --steps 1 --every 0 "$step" disk.json
wrong "--steps: '1.5'" --steps 1.5 "$step" disk.json
wrong '--until' --until nan "$step" disk.json
wrong 'exclude each other' --steps 1 --frames '%d.json' -o out.jsonl "$step" disk.json
wrong 'needs one number' --steps 1 --frames 'out.json' "$step" disk.json
wrong 'needs one number' --steps 1 --frames '%s.json' "$step" disk.json
wrong 'needs one number' --steps 1 --frames '%d-%d.json' "$step" disk.json
wrong 'give -o FILE' --steps 1 --resume "$step" disk.json
wrong 'too many' --steps 1 --step step.txt disk.json three.json
wrong 'same file' --steps 1 --log a --history ./a "$step" disk.json
wrong '--print-pipe: no loop' --steps 1 --cfl 1 --print-pipe "$step" disk.json
wrong 'needs a velocity that the mesh carries' --steps 1 --cfl 1 "$step" disk.json
printf '# a step\nadvect --vx=1 --vy=0 --dt 0.1 |  # moves\n flipdelaunay\n' >step.txt
run 0 evolve --steps 2 --step step.txt disk.json
mv out by_file
run 0 evolve --steps 2 "$step" disk.json
same out by_file
run 5 evolve --steps 2 --step missing.txt disk.json

# Bad input.
run 3 evolve --steps 1 "$step" tangled.json
says 'not valid'
says smoothcurves
run 3 evolve --steps 1 "$step" series.jsonl
says 'begins with one mesh'
run 3 evolve --steps 1 'advect --velocity-field w --dt 1' disk.json
says 'no field "w"'
: >empty.json
run 3 evolve --steps 1 -o kept.jsonl "$step" empty.json
[ ! -e kept.jsonl ] || fail "an output without a frame"

# An old output stays until the first new frame is there; a device is written in place.
echo old >kept.jsonl
run 3 evolve --steps 1 -o kept.jsonl "$step" tangled.json
[ "$(cat kept.jsonl)" = old ] || fail "the old output is gone"
run 0 evolve --steps 1 -o /dev/null "$step" disk.json
[ ! -e /dev/null.step ] || fail "a step beside a device"
run 0 evolve --steps 3 --every 1 --frames 'f/%d.json' "$step" disk.json
run 0 evolve --steps 1 --every 1 --frames 'f/%d.json' "$step" disk.json
[ "$(ls f)" = $'0.json\n1.json\nstep' ] || fail "frames of an older run: $(ls f)"
run 0 evolve --steps 4 --every 2 -o s.jsonl "$step" disk.json
[ "$(ls -A | grep -c unfinished)" = 0 ] || fail "unfinished files are left"
run 5 evolve --steps 1 -o no/such/folder/s.jsonl "$step" disk.json
run 5 evolve --steps 1 --log no/such/log "$step" disk.json
wrong 'same file' --steps 1 --log disk.json "$step" disk.json
run 3 evolve --steps 9 --every 2 -o s.jsonl --log three.json --resume "$step" disk.json
says 'three.json:1'

wrong 'the step of -o' --steps 1 -o s.jsonl --log s.jsonl.step "$step" disk.json
advect --dt 1e-9 --vx 0 --vy 0 --field 'velocity=1,0' disk.json >flow.json
cp flow.json flow-before.json
wrong 'would be overwritten' --steps 1 -o flow.json 'advect --flow flow.json --outside nearest --dt 0.1' disk.json
same flow.json flow-before.json
run 5 evolve --steps 1 --frames 'disk.json/f/%d.json' "$step" disk.json
says 'disk.json/f: '
run 5 evolve --steps 1 --step . disk.json
says '.: Is a directory'
run 0 evolve --steps 4 --every 2 -o hole.jsonl --log hole.log "$step" disk.json
head -n 1 hole.log >cut && mv cut hole.log
run 0 evolve --steps 6 --every 2 -o hole.jsonl --log hole.log --resume "$step" disk.json
says 'hole.log ends before time 0.4'
: >hole.jsonl.step
run 2 evolve --steps 6 --every 2 -o hole.jsonl --resume "$step" disk.json
says 'hole.jsonl.step is cut off'

# A closed pipe ends it without a message.
evolve --steps 100000 --every 1 "$step" disk.json 2>err | head -n 2 >out
[ "${PIPESTATUS[0]}" = 141 ] || fail "a closed pipe: ${PIPESTATUS[0]}"
silent

# Signals: the state is written, --resume goes on to the bytes of a run that nobody stopped.
for signal in INT TERM; do
  rm -f long.jsonl long.jsonl.step
  # A background job of a script ignores SIGINT, unless Python sets it right.
  python3 - "$signal" "$step" <<'E2' || fail "SIG$signal"
import os, signal, subprocess, sys, time
process = subprocess.Popen(["evolve", "--steps", "100000000", "--every", "1000000", "-o", "long.jsonl", sys.argv[2], "disk.json"],
                           stderr=subprocess.PIPE, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
for _ in range(1000):
    if not os.path.exists("long.jsonl.step"):
        time.sleep(0.01)
time.sleep(0.05)
process.send_signal(getattr(signal, "SIG" + sys.argv[1]))
message = process.stderr.read().decode()
sys.exit(process.wait() != {"INT": 130, "TERM": 143}[sys.argv[1]] or "--resume goes on" not in message)
E2
  [ "$(wc -l <long.jsonl)" = 2 ] || fail "SIG$signal left $(wc -l <long.jsonl) frames"
  qualityreport --fail-if 'invalid > 0' long.jsonl >/dev/null || fail "the state that SIG$signal left"
done

# A second signal ends it at once, in the middle of a step.
python3 - <<'E2' || fail "a second signal"
import os, signal, subprocess, sys, time
step = "advect --vx=0.01*sin(y) --vy=0.01*sin(x) --dt 1 --substeps 1000000".replace("0.01*sin(y)", "'0.01*sin(y)'").replace(
    "0.01*sin(x)", "'0.01*sin(x)'")
process = subprocess.Popen(["evolve", "--steps", "100", "-o", "slow.jsonl", step, "disk.json"], stderr=subprocess.DEVNULL)
for _ in range(1000):
    if not os.path.exists("slow.jsonl.step"):
        time.sleep(0.01)
for _ in range(2):
    time.sleep(0.1)
    process.send_signal(signal.SIGTERM)
sys.exit(process.wait() != -signal.SIGTERM)
E2

# A step that cannot be finished: status 4, the time, the place, and the last valid state.
block='advect --vx "x > 0.2 ? -8*x : 0" --vy 0 --dt 1 --substeps 50'
run 4 evolve --steps 3 -o blocked.jsonl "$block" disk.json
says 'at time 0'
says 'element'
says 'the output ends with the last valid state'
qualityreport --fail-if 'invalid > 0' blocked.jsonl >/dev/null || fail "the state of a blocked step is not valid"
sample_mesh disk 2 1e300 >late.json
run 4 evolve --steps 3 --every 1 "$step" late.json
says 'does not advance the time'
[ "$(wc -l <out)" = 1 ] || fail "$(wc -l <out) frames of a time that stands still"
# The mesh that a pass has left halfway is not written: the steps are done again.
for steps in 1 2; do evolve --steps $steps "advect --vx '0.3*x' --vy '0.3*y' --dt 0.5 | refine --max-area 0.05" disk.json | tail -n 1 >"after$steps"; done
limit=$(qualityreport --format json after1 | sed 's/.*"triangles":\([0-9]*\),"vert.*/\1/')
run 4 evolve --steps 5 -o many.jsonl "advect --vx '0.3*x' --vy '0.3*y' --dt 0.5 | refine --max-area 0.05 --max-triangles $limit" disk.json
says '--max-triangles'
tail -n 1 many.jsonl >last
same last after1

# Steps by the Courant number end where they end, and go on after an interruption with the same bytes.
bspline2mesh --max-turning 40 --field 'velocity=y,-x' "$SOURCE/samples/examples/disk.json" >turning.json
carried='advect --velocity-field velocity --dt 1 | flipdelaunay'
run 0 evolve --until 1 --cfl 0.25 --every 3 -o cfl.jsonl "$carried" turning.json
(($(wc -l <cfl.jsonl) > 3)) || fail "--cfl did not shorten steps"
grep -q '"evolve":{"steps":3}' cfl.jsonl || fail "frames do not note their steps"
head -n 3 cfl.jsonl >part.jsonl
cp cfl.jsonl.step part.jsonl.step
run 0 evolve --until 1 --cfl 0.25 --every 3 -o part.jsonl --resume "$carried" turning.json
same part.jsonl cfl.jsonl

# A velocity that turns with the mesh is steady; one that is set anew from the time is not, until it is.
advect --dt 1e-9 --vx 0 --vy 0 --field 'velocity=1,1' disk.json >steady.json
run 0 evolve --until-steady 1e-3 --steps 50 "advect --vx 0 --vy 0 --dt 0.1 --field 'velocity=exp(-20*t)+x,y'" steady.json
tail -n 1 out >last
time=$(sed 's/.*"time":\([^,]*\),.*/\1/' last)
awk "BEGIN { exit !($time > 0.25 && $time < 1.5) }" || fail "steady at $time"
finish
