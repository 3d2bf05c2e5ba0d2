#!/usr/bin/env bash
# qualityreport's tables and pages: whole for a series, whole after a failure, and --fail-if works with all of them.
. "${BASH_SOURCE%/*}/common.bash"

sample_mesh disk 2 >one.json
sample_mesh tangled 2 1 >tangled.json
cat one.json tangled.json >two.jsonl
elements=$(qualityreport --format json one.json | python3 -c 'import json, sys; print(json.load(sys.stdin)["triangles"])')

run 0 qualityreport --format csv two.jsonl
silent
(($(wc -l <out) == 2 * elements + 1)) || fail "the table should have $elements lines a mesh and one heading"
(($(grep -c '^frame,triangle,face,validity,x,y,jacobian,' out) == 1)) || fail "the heading should stand once"
grep -q '^1,.*,invalid,' out || fail "an invalid element of the second mesh should be in the table"

run 0 qualityreport --format html --title 'a < b' two.jsonl
silent
grep -q '<title>a &lt; b</title>' out || fail "the page should have the title"
[ "$(tail -n 1 out)" = '</html>' ] || fail "the page should be whole"
(($(grep -c '^<script type="application/json" class="frame">' out) == 2)) || fail "the page should have both frames"
cp out page.html
run 2 qualityreport --title 'a < b' two.jsonl
says '--title belongs to --format html'
run 0 qualityreport --format html --title 'a < b' -o page.file two.jsonl
cmp -s page.html page.file || fail "-o should write the same page"

# After a failure the page ends as it should, with the meshes before; without any there is nothing.
(cat one.json && echo '{"format": 1}') >broken.jsonl
run 3 qualityreport --format html broken.jsonl
[ "$(tail -n 1 out)" = '</html>' ] || fail "the page should be whole, with the first mesh"
echo '{"format": 1}' >broken.json
run 3 qualityreport --format html broken.json
[ ! -s out ] || fail "there is nothing to show"

for format in text json csv html; do
  run 1 qualityreport --format "$format" --fail-if 'invalid > 0' --fail-if 'triangles > 1000' two.jsonl
  says "two.jsonl: frame 1: invalid > 0: it is "
  run 0 qualityreport --format "$format" --worst 0 --bins 0 two.jsonl
done
run 2 qualityreport --format pdf one.json
run 2 qualityreport --format csv --face nowhere one.json
finish
