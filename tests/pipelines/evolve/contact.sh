#!/usr/bin/env bash
# --min-gap: advect refuses a step to a thinner gap, evolve stops there with the last valid state.
. "${BASH_SOURCE%/*}/../common.bash"
for tool in evolve advect flipdelaunay; do
  has_tool "$tool" || { echo "$tool is not built" >&2; exit 77; }
done
meet=(advect --vx 0 --vy 'x>1.6?0:y>0.25?-1:1')

# One step: the cells "upper" and "lower" are about 0.7 apart.
run 0 "${meet[@]}" --dt 0.1 --min-gap 0.05 three.json
run 4 "${meet[@]}" --dt 0.1 --min-gap 0.6 --limit three.json
says 'no step was taken: at time 0.1 curve 0 ("upper") and curve 1 ("lower") are 0.'
says 'less than the least gap of 0.6'
no_output
run 4 "${meet[@]}" --dt 0.1 --min-gap 0.9 three.json
says 'before the step, at time 0 curve 0 ("upper") and curve 1 ("lower")'
no_output
run 2 "${meet[@]}" --dt 0.1 --min-gap 0 three.json
says --min-gap
run 2 "${meet[@]}" --dt 0.1 --min-gap x three.json

# evolve stops, and its output ends with the last state before contact.
run 4 evolve --until 1 --every 100 "advect --vx 0 --vy 'x>1.6?0:y>0.25?-1:1' --dt 0.02 --min-gap 0.1 | flipdelaunay" three.json
says 'no step was taken: at time 0.'
says 'less than the least gap of 0.1'
says 'the output ends with the last valid state'
[ "$(wc -l <out)" = 2 ] || fail "$(wc -l <out) frames, not 2"
tail -n 1 out >last.json
run 0 advect --vx 0 --vy 0 --dt 1 --min-gap 0.1 last.json
run 4 "${meet[@]}" --dt 0.02 --min-gap 0.1 last.json
# --gap hold: the same flow, and no frame with a gap below 0.9 of the least one; every frame is valid (advect reads none else).
run 2 "${meet[@]}" --dt 0.1 --gap hold three.json
says 'needs --min-gap'
run 2 "${meet[@]}" --dt 0.1 --gap wide --min-gap 0.1 three.json
says 'neither stop nor hold'
press='advect --vx 0 --vy "x>1.6?0:0.25-y" --dt 0.02 --min-gap 0.3 --gap hold | flipdelaunay'
run 0 evolve --steps 60 --every 1 "$press" three.json
[ "$(wc -l <out)" = 61 ] || fail "$(wc -l <out) frames, not 61"
mv out held.jsonl
run 0 advect --vx 0 --vy 0 --dt 1 --min-gap 0.27 held.jsonl
run 4 advect --vx 0 --vy 0 --dt 1 --min-gap 0.33 held.jsonl
finish
