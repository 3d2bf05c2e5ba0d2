#!/usr/bin/env bash
# -o FILE appears whole or not at all.
. "${BASH_SOURCE%/*}/common.bash"
mkdir results

only() { # only FILE...: the folder of results holds these and nothing else
  local found
  found=$(ls -A results)
  [ "$found" = "$(printf '%s\n' "$@")" ] || fail "results holds: $found"
}

for tool in "${mesh_filters[@]}"; do
  rm -f results/*
  filter "$tool" disk.json >plain.json
  run 0 filter "$tool" disk.json -o results/mesh.json
  no_output
  same results/mesh.json plain.json
  only mesh.json
  { head -n 2 series.jsonl; echo '{"broken":'; } >bad.jsonl
  run 3 filter "$tool" bad.jsonl -o results/mesh.json
  same results/mesh.json plain.json
  only mesh.json
  run 3 filter "$tool" bad.jsonl -o results/new.json
  only mesh.json
done

# A file may be input and output at once.
cp series.jsonl results/mesh.json
run 0 passthrough results/mesh.json -o results/mesh.json
same results/mesh.json series.jsonl
only mesh.json

# A new file has the permissions that the shell gives one; a file that was there keeps its own. A link stays a link.
rm results/*
(umask 027 && passthrough disk.json -o results/mesh.json)
[ "$(stat -c %a results/mesh.json)" = 640 ] || fail "permissions of a new file: $(stat -c %a results/mesh.json)"
chmod 604 results/mesh.json
run 0 passthrough series.jsonl -o results/mesh.json
[ "$(stat -c %a results/mesh.json)" = 604 ] || fail "permissions of an old file: $(stat -c %a results/mesh.json)"
ln -s results/mesh.json link.json
run 0 passthrough disk.json -o link.json
[ -L link.json ] || fail "the link was replaced"
same results/mesh.json disk.json
only mesh.json

# Devices and named pipes are written in place.
run 0 passthrough disk.json -o /dev/null
[ -c /dev/null ] || fail "/dev/null was replaced"
mkfifo pipe
cat pipe >through.json &
run 0 passthrough disk.json -o pipe
wait
[ -p pipe ] || fail "the named pipe was replaced"
same through.json disk.json

run 5 passthrough disk.json -o no/such/folder/mesh.json
says 'passthrough: no/such/folder/mesh.json'
run 5 passthrough disk.json -o results
only mesh.json

# A signal leaves nothing behind.
mkfifo slow
passthrough slow -o results/never.json 2>err &
job=$!
exec 9>slow
head -n 1 series.jsonl >&9
for i in {1..100}; do ls -A results | grep -q never && break; sleep 0.05; done
ls -A results | grep -q never || fail "the temporary file should stand beside the target"
ls -A results | grep -q '^never.json.unfinished-......$' || fail "its name should say what it is: $(ls -A results)"
kill -TERM "$job"
wait "$job" 2>/dev/null
exec 9>&-
only mesh.json
finish
