#!/usr/bin/env bash
# Tangled meshes through smoothcurves: what it mends, what it refuses to write, what it says, and MSH in and out.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
for tool in bspline2mesh refine advect smoothcurves qualityreport import-msh export-msh; do has_tool "$tool" || exit 77; done

# invalid FILE: how many elements are not valid.
invalid() { qualityreport --format json "$1" | grep -o '"invalid":[0-9]*' | cut -d: -f2; }

bspline2mesh "$SOURCE/samples/three-cells/cells.json" | refine --size 0.08 -o cells.json
w='max(0,1-4*((x+3.2)^2+(y-0.5)^2))^2'
stir() { advect --vx="-(y-0.5)*$1*$w" --vy="(x+3.2)*$1*$w" --dt 1 --substeps 8 --force -q cells.json; }

# A mesh that is not too curved passes byte for byte.
run 0 smoothcurves cells.json
same out cells.json

# A curve that runs round its face the wrong way forbids every valid element.
cat >rim.json <<'EOF'
{"format":"pliant-mesh","version":1,"degree":2,"points":[0,2,2,2,2,0,0,4,4,0,0,0],"triangles":[0,1,2,3,4,5],"triangle_faces":[0],"constrained_edges":[{"curve":0,"span":0,"points":[0,3,1]},{"curve":0,"span":1,"points":[1,4,2]},{"curve":0,"span":2,"points":[2,5,0]}],"fields":[],"boundary":{"vertices":[],"faces":[{"name":"drop"}],"curves":[{"name":"rim","degree":2,"closed":true,"knots":[0,1,2,3],"points":[4,0,0,0,0,4],"left":0,"right":null}],"cusps":[]}}
EOF
run 4 smoothcurves -o absent.json rim.json
says 'elements stay invalid; --keep-going writes the mesh all the same'
says '  element 0 at '
says 'the curves forbid a valid mesh: '
[ ! -e absent.json ] || fail 'a mesh with invalid elements was written'
run 0 smoothcurves --keep-going -o kept.json rim.json
[ "$(invalid kept.json)" -gt 0 ] || fail 'nothing was left to keep'

# So does one that crosses itself.
stir 8 >crossed.json
run 4 smoothcurves --max-sweeps 1 crossed.json
says "the curves forbid a valid mesh: curve 'close' (0) at parameter"

# What smoothing cannot mend is meshed anew, unless the mesh is wanted as it is.
near='max(0,1-16*((x+3.2)^2+(y-0.5)^2))^2'
advect --vx="-(y-0.5)*8*$near" --vy="(x+3.2)*8*$near" --dt 1 --force -q cells.json >far.json
run 0 smoothcurves --max-sweeps 1 --keep-going -o kept.json far.json
[ "$(invalid kept.json)" -gt 0 ] || fail 'nothing was left to keep'
run 0 smoothcurves --max-sweeps 1 --report report.json -o smooth.json far.json
[ "$(invalid smooth.json)" = 0 ] || fail 'regions meshed anew have invalid elements'
qualityreport --fail-if 'faults > 0' smooth.json >/dev/null || fail 'regions meshed anew have faults'
grep -Eq '"patches_remeshed": ?[1-9]' report.json || fail "no region was meshed anew: $(cat report.json)"
grep -q 'elements invalid: .* were replaced by .* new ones' report.json || fail 'nothing is said of regions meshed anew'

# A mesh whose vertices a vortex has moved across edges becomes valid, without options and with them.
stir 5 >far.json
[ "$(invalid far.json)" -gt 0 ] || fail 'the wide vortex tangles nothing'
run 0 smoothcurves -o smooth.json far.json
[ "$(invalid smooth.json)" = 0 ] || fail 'the plain smoother leaves invalid elements'

stir 3.5 >vortex.json
[ "$(invalid vortex.json)" -gt 0 ] || fail 'the vortex tangles nothing'
for options in '--vertices' '--vertices --flips' '--vertices --flips --split' '--vertices --measure control'; do
  # shellcheck disable=SC2086
  run 0 smoothcurves $options -o smooth.json vortex.json
  [ "$(invalid smooth.json)" = 0 ] || fail "$options leaves invalid elements"
  qualityreport --fail-if 'faults > 0' smooth.json >/dev/null || fail "$options leaves faults"
done

# The report has the counts, and the places of elements that stay too curved.
run 0 smoothcurves --keep-going --report report.json -o smooth.json vortex.json
for name in too_curved edges_smoothed vertices_moved flips splits still_curved needs_split invalid patches_remeshed; do
  grep -q "\"$name\":" report.json || fail "no $name in the report"
done

# Gmsh's users: MSH in, MSH out.
export-msh -o bad.msh vortex.json
import-msh bad.msh 2>/dev/null | smoothcurves --vertices | export-msh -o good.msh || fail 'the pipe from MSH to MSH'
import-msh good.msh >good.json 2>/dev/null || fail 'good.msh is not read'
[ "$(invalid good.json)" = 0 ] || fail 'good.msh has invalid elements'

# Wrong usage.
run 2 smoothcurves --min-scaled-jacobian 1 cells.json
says '--min-scaled-jacobian must be below 1'
run 2 smoothcurves --measure area cells.json
finish
