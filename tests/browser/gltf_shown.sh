#!/usr/bin/env bash
# three.js shows the frame that the time asks for: cells of one area, placed elsewhere in each frame; and heights.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
sample_mesh disk 2 0 >one.json
sample_mesh three 2 1 >three.json
cat one.json three.json one.json | export-gltf --color face --fps 1 -o series.glb
cat one.json three.json one.json | export-gltf --precision float --color face --fps 1 -o float.glb
# The disk with its y as a field: control values of a linear function are its values at the control points.
python3 -c '
import json
import sys

mesh = json.load(sys.stdin)
mesh["fields"] = [{"name": "y", "components": 1, "by_face": False, "values": mesh["points"][1::2]}]
json.dump(mesh, sys.stdout)' <one.json >lifted.json
export-gltf --color field:y --height y:0.5 --no-edges --outline 0 lifted.json -o surface.glb
"$NODE" "$SOURCE/tests/browser/gltf_shown.mjs" "$scratch"
