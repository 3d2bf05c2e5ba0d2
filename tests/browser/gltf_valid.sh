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
export-gltf --color shape --quantize series.jsonl -o quantized.glb
export-gltf --color face series.jsonl -o series.gltf
head -n 2 series.jsonl | export-gltf >two.glb
sample_mesh tangled 2 | export-gltf -o tangled.gltf
"$NODE" "$SOURCE/tests/pipelines/gltf_validate.mjs" ./*.glb ./*.gltf
