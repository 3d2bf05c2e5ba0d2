#!/usr/bin/env bash
# A mesh that goes through pipes stays the same byte for byte.
. "${BASH_SOURCE%/*}/../common.bash"

for degree in 1 2 3 4 5; do
  sample_mesh three "$degree" >in.json
  run 0 passthrough in.json
  same out in.json
  silent
  passthrough <in.json | passthrough - | passthrough >thrice.json
  same thrice.json in.json
done
run 0 passthrough series.jsonl
same out series.jsonl

# A document over many lines becomes one line, and then stays.
python3 -c 'import json, sys; print(json.dumps(json.load(sys.stdin), indent=1))' <disk.json >pretty.json
run 0 passthrough pretty.json
(($(wc -l <out) == 1)) || fail "the output has more than one line"
cp out once.json
run 0 passthrough once.json
same out once.json
python3 - disk.json once.json <<'PYTHON' || fail "a pretty-printed document changed its meaning"
import json, sys
a, b = (json.load(open(name)) for name in sys.argv[1:])
sys.exit(a != b)
PYTHON

# A tool that has nothing to do leaves the mesh as it is.
if has_tool advect; then
  run 0 advect --dt 0.1 --until 0 --vx 1 --vy y disk.json
  same out disk.json
fi
if has_tool flipdelaunay; then
  flipdelaunay disk.json >delaunay.json
  run 0 flipdelaunay delaunay.json
  same out delaunay.json
fi

# A pipe of tools over a series is the tools one after the other over each frame.
for tool in "${mesh_filters[@]}"; do
  filter "$tool" series.jsonl >all.jsonl 2>err || fail "$tool over a series: $(head -c 300 err)"
  while IFS= read -r frame; do printf '%s\n' "$frame" | filter "$tool"; done <series.jsonl >each.jsonl
  same all.jsonl each.jsonl
done
finish
