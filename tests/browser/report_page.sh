#!/usr/bin/env bash
# The HTML report in Chromium, from files and without a network: a good mesh, one with invalid elements whose face has
# a name full of markup, meshes of several degrees, a series, and one of 50,000 elements.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
for degree in 1 2 3 5; do sample_mesh three "$degree" >"p$degree.json"; done
sample_mesh tangled 2 | sed 's#"faces":\[{"name":"[^"]*"#"faces":[{"name":"</script><b id=escaped>"#' >tangled.json
for time in 0 1 2; do sample_mesh disk 2 "$time"; done >series.jsonl
cat tangled.json >>series.jsonl
bspline2mesh --max-area 0.000045 "$SOURCE/samples/three-cells/cells.json" >large.json
for mesh in *.json *.jsonl; do
  qualityreport --format html --worst 7 -o "${mesh%.*}.html" "$mesh"
  qualityreport --format csv -o "${mesh%.*}.csv" "$mesh"
done
"$NODE" "$SOURCE/tests/browser/report_page.mjs" "$scratch"
