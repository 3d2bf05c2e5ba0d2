#!/usr/bin/env bash
# The tools of a step read what those before them write, wherever the mesh lies, up to 1e9 widths from the origin.
. "${BASH_SOURCE%/*}/common.bash"
for tool in bspline2mesh advect flipdelaunay refine coarsen smoothcurves qualityreport; do has_tool "$tool" || exit 77; done

# through NAME DEGREE WIDTHS: the boundary through all tools; `passthrough` reads each document as a tool does.
through() {
  local name=$1 degree=$2 widths=$3
  sample_boundary "$name" "$degree" "$widths" >in.json
  for step in "bspline2mesh --degree $degree --field u=x-y" "advect --dt 0.02 --vx 0.1 --vy 0 --limit" flipdelaunay \
    "refine --max-turning 20" "coarsen --factor 1.5" "smoothcurves --vertices"; do
    # shellcheck disable=SC2086
    run 0 $step -q in.json
    [ -s out ] || { fail "$name, degree $degree, $widths widths: ended at ${step%% *}"; return; }
    mv out in.json
  done
  run 0 passthrough in.json
  same out in.json
  run 0 qualityreport --format json --fail-if 'invalid > 0' --fail-if 'faults > 0' in.json
}
for widths in 1 1e3 1e6 1e9; do
  through square 1 "$widths"
  through gear 1 "$widths"
  through interface 2 "$widths"
  through glyph 2 "$widths"
  through divided 3 "$widths"
done
through biconcave 4 1e9
through crescent 4 1e6
through cell 5 1e9
through annulus 5 1e6

# A linear field stays linear while the mesh moves, to a few units in the last place of the coordinates.
sample_boundary interface 2 1e9 | bspline2mesh -q --max-area 0.1 --field 'u=(x-4123105625)-2*(y-2061552812)' |
  refine -q --max-area 0.03 | coarsen -q --factor 2 --max-area 0.3 | smoothcurves -q --vertices >linear.json
python3 - linear.json <<'PYTHON' || fail "a linear field did not stay linear"
import json, sys
mesh = json.load(open(sys.argv[1]))
points, values = mesh["points"], mesh["fields"][0]["values"]
unit = 2.0 ** -21  # in the last place of the coordinates
off = max(abs(u - ((x - 4123105625) - 2 * (y - 2061552812))) for x, y, u in zip(points[::2], points[1::2], values))
sys.exit(off > 16 * unit)
PYTHON

# Messages name places with as many digits as the offset takes.
sample_boundary interface 2 1e6 | bspline2mesh -q >in.json
run 4 advect --dt 1e4 --vx 'y*y' --vy 0 in.json
says "at (4123"
grep -qE 'at \([0-9]{7}\.[0-9]{2,}, ' err || fail "a place without digits behind the point: $(head -c 300 err)"
finish
