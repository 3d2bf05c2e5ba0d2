#!/usr/bin/env bash
# What export-gltf writes passes the Khronos validator, in every degree, colouring and form.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
for degree in 1 2 3 4; do
  sample_mesh three $degree >mesh.json
  for color in none face shape field:u; do
    export-gltf --color $color mesh.json -o "$degree-${color/:/-}.glb"
  done
done
for i in 0 1 2 3 4; do sample_mesh three 2 0.$i; done >series.jsonl
export-gltf --color field:u --circle 1.5,0.5,0.25 series.jsonl -o series.glb
export-gltf --color shape --precision float series.jsonl -o float.glb
export-gltf --color face --height u --lit series.jsonl -o lifted.glb
export-gltf --color field:u --height u:-0.5 --lit --precision float series.jsonl -o lifted-float.glb
export-gltf --color face series.jsonl -o series.gltf
head -n 2 series.jsonl | export-gltf >two.glb
sample_mesh tangled 2 | export-gltf -o tangled.gltf
# Far away, and of extreme size: a node has the translation and the scale that single precision cannot.
place() {  # SCALE OFFSET
  python3 -c '
import json
import sys

scale, offset = map(float, sys.argv[1:])
for line in sys.stdin:
    mesh = json.loads(line)
    for object in mesh, mesh["boundary"], *mesh["boundary"]["curves"]:
        for name in "points", "vertices":
            if name in object:
                object[name] = [x * scale + offset for x in object[name]]
    print(json.dumps(mesh))' "$@"
}
for degree in 1 2 4; do
  for at in '1 5e6' '1 -3e11' '1e-150 0' '1e150 0' '1e-30 2e-29'; do
    sample_mesh three $degree | place $at | export-gltf --color field:u -o "$degree-${at/ /-at-}.glb"
    grep -aqE '"(translation|scale)"' "$degree-${at/ /-at-}.glb" || { echo "no node places $at" >&2; exit 1; }
  done
done
place 1e9 -5e15 <series.jsonl | export-gltf --color shape -o far-series.glb
{ sample_mesh three 2; sample_mesh three 2 1 | place 1 4e7; } | export-gltf -o far-apart.gltf
"$NODE" "$SOURCE/tests/pipelines/gltf_validate.mjs" ./*.glb ./*.gltf
