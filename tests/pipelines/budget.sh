#!/usr/bin/env bash
# The number of triangles is low where curves come close. A warning comes before there are very many, and status 4 where
# they are too many.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
cases=$SOURCE/tests/pipelines/cases
triangles() { python3 -c 'import json, sys; print(len(json.load(open(sys.argv[1]))["triangle_faces"]))' "$1"; }
# fewer FILE N: the mesh has fewer triangles than N.
fewer() { (($(triangles "$1") < $2)) || fail "$1 has $(triangles "$1") triangles, not below $2"; }

run 0 import-svg --planar -o boundary.json "$cases/tangent-discs.svg"
run 0 bspline2mesh -o mesh.json boundary.json
fewer mesh.json 1000
run 0 import-svg --planar --degree 3 -o boundary.json "$cases/traced-outline.svg"
run 0 bspline2mesh -o mesh.json boundary.json
fewer mesh.json 8000

# A gap that is thin for its spans: told beforehand, and left if asked; coarsen and the next refine know.
run 0 import-svg --planar -q -o boundary.json "$cases/slivers.svg"
run 4 bspline2mesh --max-triangles 20000 boundary.json
says "filling thin gaps takes some"
says "there are more than 20000 triangles"
says "--thin keep"
no_output
run 0 bspline2mesh --thin keep -o mesh.json boundary.json
silent
fewer mesh.json 100
grep -q '"thin":"keep"' mesh.json || fail "the criterion is not written"
run 0 refine -o again.json mesh.json
same mesh.json again.json
run 0 coarsen -o coarse.json mesh.json
run 0 refine -o again.json coarse.json
same coarse.json again.json
run 2 refine --thin both mesh.json
sed 's/"thin":"keep"/"thin":"perhaps"/' mesh.json >perhaps.json
run 3 refine perhaps.json
says '/criteria/thin: expected "keep" or "refine"'

# What needs too many is refused beforehand.
for goal in --max-area=1e-12 --size=1e-9 --max-turning=1e-6 --face-area=cell=1e-13; do
  run 4 refine "$goal" disk.json
  says "at least"
  says "--max-triangles"
  no_output
done
run 4 refine --max-area 1e-3 --max-triangles 500 disk.json
run 0 refine --max-area 1e-3 --max-triangles 10000 disk.json
# Lengths are above zero.
for size in -1 0 0/0 'x-5' 'sqrt(x-9)'; do
  run 2 refine --size "$size" disk.json
  says "should be above zero"
  no_output
done
# Memory that runs out is status 4.
if (ulimit -v 400000 && refine --max-area 1e-1 disk.json >out 2>err); then
  (ulimit -v 400000; exec refine --max-area 1e-6 disk.json) >out 2>err
  (($? == 4)) || fail "out of memory: status $? ($(head -c 300 err))"
  says "more memory than there is"
fi

# A second refinement does nothing, also on the meshes where curves or a greater angle once made it go on for ever.
for name in cascade:28:0.02 refine-left:20.7:0.016341; do
  IFS=: read -r file angle area <<<"$name"
  run 0 refine --min-angle "$angle" --max-area "$area" -o first.json "$cases/$file.json"
  run 0 refine -o second.json first.json
  same first.json second.json
  fewer first.json 200
done
finish
