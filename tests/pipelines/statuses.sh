#!/usr/bin/env bash
# Exit statuses and messages: help, wrong usage, no result, reading and writing that fail, closed pipes.
. "${BASH_SOURCE%/*}/common.bash"

for tool in passthrough "${built[@]}"; do
  run 0 "$tool" --help
  silent
  grep -q -- --version out || fail "$tool --help does not name --version"
  run 0 "$tool" -h
  run 0 "$tool" --version
  silent
  grep -Eq "^$tool .*[0-9]+\.[0-9]+" out || fail "$tool --version says: $(cat out)"
  run 2 "$tool" --no-such-option
  no_output
  says "$tool: "
  run 2 "$tool" disk.json three.json
  run 2 "$tool" -q -v disk.json
done

# Numbers of options are finite, and positive where they must be.
for value in nan inf -1 0 1e999 '' abc '1 2' 0x; do
  run 2 passthrough --max-area "$value" disk.json
  no_output
done
run 2 passthrough --min-angle 60 disk.json
says '--min-angle'
run 2 passthrough --face-area cell disk.json
run 2 passthrough --face-area cell=0 disk.json
run 2 passthrough --face-area =1 disk.json
run 2 passthrough --face-area nobody=1 disk.json
says "no face 'nobody'"
run 2 passthrough --face-area cell=1 --face-area cell=2 disk.json
run 0 passthrough --face-area cell=0.5 --min-angle 0 --size '1.1+x' disk.json
grep -qF '"criteria":{"min_angle":0,"face_area":{"cell":0.5},"size":"1.1+x"}' out || fail "criteria are written back"
cp out with.json
run 0 passthrough --face-area cell=0.25 --max-turning 30 with.json
grep -qF '"criteria":{"min_angle":0,"face_area":{"cell":0.25},"size":"1.1+x","max_turning":30}' out ||
  fail "an option replaces its entry and leaves the others"

# A field of wanted lengths must be there, and have one component.
run 2 refine --size-field nothing disk.json
says "--size-field: the mesh has no field 'nothing'"
sed 's/"criteria":{/"criteria":{"size_field":"gone",/' with.json >gone.json
run 3 coarsen gone.json
says '/criteria/size_field'

# No result: status 4, the frames before stay, messages only on standard error.
run 4 passthrough --stop-at 2 series.jsonl
says 'passthrough: series.jsonl: frame 2: told to stop'
head -n 2 series.jsonl >two.jsonl
same out two.jsonl
run 4 passthrough --stop-at 2 -q series.jsonl
says 'passthrough: series.jsonl: frame 2: told to stop'
run 4 passthrough --spoil-at 1 series.jsonl
says 'frame 1'
says 'not finite'
(($(wc -l <out) == 1)) || fail "a mesh that is not finite must not be written"

# What nobody expects is a fault of the program, and says so: status 6.
run 6 passthrough --fault logic series.jsonl
no_output
says 'passthrough: series.jsonl: frame 0: internal error: told to fail; please report it'
run 6 passthrough --fault integer series.jsonl
no_output
says 'passthrough: internal error: an exception of an unknown kind; please report it'
run 6 passthrough --fault early series.jsonl
says 'passthrough: internal error: told to fail; please report it'
run 4 passthrough --fault length series.jsonl
says 'more memory than there is'

# Reading that fails.
for tool in "${mesh_filters[@]}"; do
  run 5 filter "$tool" no-such-file.json
  no_output
  says "$tool: no-such-file.json"
  run 5 filter "$tool" .
done
run 5 bash -c 'passthrough <&-'

# Writing that fails.
if [ -w /dev/full ]; then
  for tool in "${mesh_filters[@]}"; do
    status=0
    filter "$tool" disk.json >/dev/full 2>err || status=$?
    ((status == 5)) || fail "$tool to a full device: status $status"
    says "$tool: "
    run 5 filter "$tool" disk.json -o /dev/full
  done
  status=0
  passthrough --help >/dev/full 2>err || status=$?
  ((status == 5)) || fail "--help to a full device: status $status"
fi
run 5 bash -c 'passthrough disk.json >&-'
run 5 passthrough disk.json --report no/such/folder/report.json
run 2 passthrough disk.json --report -

# A closed pipe ends a tool without a word, also where the parent ignores SIGPIPE.
for i in {1..300}; do cat series.jsonl; done >long.jsonl
for tool in "${mesh_filters[@]}"; do
  { filter "$tool" long.jsonl 2>err; echo $? >status; } | head -c 1 >out
  silent
  (($(cat status) == 141)) || fail "$tool: status $(cat status) for a closed pipe"
done
(trap '' PIPE; { passthrough long.jsonl 2>err; echo $? >status; } | head -c 1 >out)
silent
(($(cat status) == 141)) || fail "status $(cat status) for a closed pipe under an ignored SIGPIPE"
finish
