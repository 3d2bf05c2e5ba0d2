#!/usr/bin/env bash
# three.js shows the frame that the time asks for: cells of one area, placed elsewhere in each frame.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
sample_mesh disk 2 0 >one.json
sample_mesh three 2 1 >three.json
cat one.json three.json one.json | export-gltf --color face --fps 1 -o series.glb
"$NODE" "$SOURCE/tests/browser/gltf_shown.mjs" series.glb
