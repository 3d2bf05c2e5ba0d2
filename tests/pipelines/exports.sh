#!/usr/bin/env bash
# The pictures from the outside: frames, names of files, obstacles beside the input, tangled meshes, wrong names.
. "${BASH_SOURCE%/*}/common.bash"
has_tool export-svg && has_tool export-gltf || exit 77

sample_mesh disk 2 0 >a.json
sample_mesh three 2 1 >b.json
cat a.json b.json >series.jsonl

for tool in export-svg export-gltf; do
  run 0 $tool --circle 1,2,0.5 --circle 3,2,0.5 --color field:u series.jsonl
  silent
  cp out first
  run 0 $tool --circle 1,2,0.5 --circle 3,2,0.5 --color field:u - <series.jsonl
  same first out
  run 2 $tool --color field:heat a.json
  says "no field 'heat'"
  run 2 $tool --color beauty a.json
  run 2 $tool --colormap beauty a.json
  run 2 $tool --range 2:1 a.json
  run 2 $tool --range nan:1 a.json
  run 2 $tool --circle 1,2 a.json
  run 2 $tool --circle 1,2,-3 a.json
  run 0 $tool --range -1:1 --color element_area a.json
  sample_mesh tangled 2 >tangled.json
  run 0 $tool tangled.json
  grep -q invalid out || fail "$tool does not mark invalid elements"
done

run 0 export-svg series.jsonl --frame 1
grep -q '<title>Mesh at time 1</title>' out || fail "--frame 1 is not the second mesh"
cp out second
run 0 export-svg series.jsonl --frame -1
same second out
run 0 export-svg series.jsonl --frame=-2
grep -q '<title>Mesh at time 0</title>' out || fail "--frame -2 is not the first mesh"
for frame in 2 -3; do
  run 2 export-svg series.jsonl --frame $frame
  says "has 2 meshes"
  no_output
done
# A number is read in decimal digits, and none is taken for another one.
for frame in 9223372036854775807 9223372036854775808 -9223372036854775808 1000000001 0x1 1.0 last; do
  run 2 export-svg "--frame=$frame" series.jsonl
  says "'$frame' is not a whole number from -1000000000 to 1000000000"
  no_output
done
for frame in 01 +1; do
  run 0 export-svg --frame $frame series.jsonl
  same second out
done
# Reading ends behind the frame, so that a fault there is not found.
{ cat series.jsonl; echo '{"format":"pliant-mesh","version":1}'; } >broken.jsonl
for i in {1..300}; do cat series.jsonl; done >long.jsonl
for tool in export-svg export-msh export-vtu; do
  has_tool $tool || continue
  run 0 $tool -q --frame 1 series.jsonl
  cp out wanted
  for options in '--frame 1 broken.jsonl' '--frame=-1 series.jsonl'; do
    run 0 $tool -q $options
    silent
    same wanted out
  done
  for frame in 2 -1 -2 -9; do
    run 3 $tool --frame $frame broken.jsonl
    says "$tool: broken.jsonl:3: frame 2: "
    no_output
  done
  { passthrough long.jsonl 2>writer; echo $? >status; } | $tool -q --frame 1 >out 2>err ||
    fail "$tool: the frame of a long series: $(cat err)"
  silent
  same wanted out
  [ ! -s writer ] || fail "the writer is ended without a word: $(cat writer)"
  (($(cat status) == 141)) || fail "$tool: status $(cat status) of a writer whose reader has what it wants"
done
run 2 export-svg --box 0,0,0,1 a.json
run 0 export-svg --color field:u a.json
grep -q '>field u</text>' out || fail "the name of a field of one letter should be legible"

run 0 export-gltf a.json -o a.glb
run 0 export-gltf a.json -o a.gltf
[ "$(head -c 4 a.glb)" = glTF ] || fail "a.glb is not binary"
[ "$(head -c 1 a.gltf)" = '{' ] || fail "a.gltf is not JSON"
run 0 export-gltf a.json -o A.GLTF
same A.GLTF a.gltf
run 0 export-gltf a.json
same a.glb out
run 0 export-gltf --no-binary a.json
same a.gltf out
# Lines lie a little above the mesh, and no box is so thin that normals overflow in single precision.
for options in '' '--precision float' '--lit' '--lit --precision float' '--lit --height u' '--lit --height u:0'; do
  run 0 export-gltf $options --no-binary a.json
  python3 - <<'PYTHON' || fail "export-gltf $options: the nodes are out of place"
import json
nodes = json.load(open("out"))["nodes"]
for node in nodes:
    assert min(node.get("scale", [1])) == 0 or min(node.get("scale", [1])) > 1e-16, node
def heights(node, scale):
    low = node.get("translation", [0, 0, 0])[2] * scale
    inner = scale * node.get("scale", [1, 1, 1])[2]
    return [low] + [low + height for child in node.get("children", []) for height in heights(nodes[child], inner)]
children = {child for node in nodes for child in node.get("children", [])}
for number, node in enumerate(nodes):
    assert number in children or max(map(abs, heights(node, 1))) < 10, node
assert len(nodes) > 3
PYTHON
done
for option in '--fps nan' '--outline nan' '--outline -1' '--fps 1e9'; do
  run 2 export-gltf $option a.json
  says ' is not a number from '
done
run 2 export-svg --width nan a.json
says "--width: 'nan' is not a number from 50 to "
# -v says what was written.
for tool in export-svg export-msh export-gltf export-vtu; do
  run 0 "$tool" -v disk.json
  says ' triangles, '
  says "$(wc -c <out) bytes"
done
finish
