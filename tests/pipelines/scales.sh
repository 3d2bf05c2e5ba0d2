#!/usr/bin/env bash
# Tools give, for a boundary times a power of two, the same mesh times that power, bit for bit. Powers out of range are
# status 3.
. "${BASH_SOURCE%/*}/common.bash"
for tool in bspline2mesh advect flipdelaunay refine coarsen smoothcurves qualityreport import-msh export-msh; do
  has_tool "$tool" || exit 77
done

# times EXPONENT POWER NUMBER...: each number, times that power of 2^EXPONENT.
times() { python3 -c 'import math, sys; print(*(repr(math.ldexp(float(x), int(sys.argv[1]) * int(sys.argv[2]))) for x in sys.argv[3:]))' "$@"; }

# through NAME DEGREE EXPONENT: all tools' documents, one a line, in NAME.EXPONENT; the report in NAME.EXPONENT.report.
through() {
  local name=$1 degree=$2 exponent=$3 length area size s
  length=$(times "$exponent" 1 0.01)
  area=$(times "$exponent" 2 0.1)
  s=$(times "$exponent" 1 1)
  size="$s*(0.4+0.1*sin(x/$s))"
  sample_boundary "$name" 2 0 "$exponent" >in.json
  : >"$name.$exponent"
  while read -r -a step; do
    run 0 "${step[@]}" -q in.json
    cat out >>"$name.$exponent"
    mv out in.json
  done <<STEPS
bspline2mesh --degree $degree --max-area $area --field u=sin(x/$s)*cos(y/$s) --field v=-0.2*y,0.1*x
advect --dt 0.05 --vx -y --vy x*x/$s+y/4 --limit --keep-area
advect --dt 0.05 --velocity-field v --limit
flipdelaunay
refine --size $size
coarsen --tolerance $length --keep-area --factor 1.5
smoothcurves --vertices
STEPS
  run 0 qualityreport --format json in.json
  mv out "$name.$exponent.report"
}
cat >compare.py <<'PYTHON'
# compare.py NAME EXPONENT: NAME.EXPONENT against NAME.0
import json, math, sys
name, exponent = sys.argv[1], int(sys.argv[2])
def times(values, power=1):
    return [math.ldexp(value, power * exponent) for value in values]
def scaled(mesh):
    mesh["points"] = times(mesh["points"])
    mesh["boundary"]["vertices"] = times(mesh["boundary"]["vertices"])
    for curve in mesh["boundary"]["curves"]:
        curve["points"] = times(curve["points"])
        curve["removal_error"] = times([curve["removal_error"]])[0]
    mesh["criteria"]["max_area"] = times([mesh["criteria"]["max_area"]], 2)[0]
    for field in mesh["fields"]:
        if field["name"] == "v":
            field["values"] = times(field["values"])
    return mesh
for one, other in zip(open(f"{name}.0"), open(f"{name}.{exponent}"), strict=True):
    one, other = scaled(json.loads(one)), json.loads(other)
    one["criteria"].pop("size", None), other["criteria"].pop("size", None)  # expressions, which do not scale
    if one != other:
        sys.exit("differs in " + ", ".join(key for key in one if one[key] != other[key]))
one, other = (json.load(open(f"{name}.{k}.report")) for k in (0, exponent))
assert times([one["area"]], 2) == [other["area"]]
powers = {"jacobian": 2, "jacobian_max": 2, "edge_length": 1, "element_area": 2, "shape": 0, "distortion": 0}
for metric, power in powers.items():
    for key in ("min", "max", "mean"):
        assert times([one[metric][key]], power) == [other[metric][key]], (metric, key)
PYTHON
for sample in "cell 3" "interface 2"; do
  read -r name degree <<<"$sample"
  through "$name" "$degree" 0
  for exponent in -300 -150 -20 20 150 300; do
    through "$name" "$degree" "$exponent"
    python3 compare.py "$name" "$exponent" || fail "$name times 2^$exponent"
  done
done

# MSH out and in again.
for exponent in 0 -490 300; do
  sample_boundary cell 2 0 "$exponent" | bspline2mesh -q >in.json
  export-msh -q in.json >in.msh
  run 0 import-msh -q in.msh
  mv out "msh.$exponent"
  python3 - msh.0 "msh.$exponent" "$exponent" <<'PYTHON' || fail "MSH times 2^$exponent"
import json, math, sys
one, other = (json.load(open(name)) for name in sys.argv[1:3])
assert [math.ldexp(x, int(sys.argv[3])) for x in one["points"]] == other["points"]
assert one["triangles"] == other["triangles"]
PYTHON
done

# Out of range: one message with the bounds.
for exponent in -520 520 1000; do
  sample_boundary square 1 0 "$exponent" >b.json
  run 3 bspline2mesh b.json
  says "2^-510"
  no_output
done
cat >far.json <<'JSON'
{"format": "pliant-mesh", "version": 1, "degree": 1, "points": [0.0, 0.0, 1.7e+308, 0.0, 0.0, 1.0],
 "triangles": [0, 1, 2], "triangle_faces": [0], "constrained_edges": [],
 "boundary": {"vertices": [], "faces": [{"name": "f"}], "curves": []}}
JSON
for tool in qualityreport flipdelaunay export-svg export-gltf export-msh export-vtu; do
  has_tool "$tool" || continue
  run 3 "$tool" far.json
  says "2^510"
done
# A coordinate that would lose digits beside the size is named.
sample_boundary square 1 0 400 | sed 's/"vertices":\[0,0,/"vertices":[0,1e-300,/' >b.json
run 3 bspline2mesh b.json
says "/vertices/1: is 1e-300 in a document of size"
finish
