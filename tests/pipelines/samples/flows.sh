#!/usr/bin/env bash
# The samples of navierstokes, made by their Makefiles on coarse meshes and for short times. Their own checks must hold, and
# fail where a claim does not.
. "${BASH_SOURCE%/*}/../common.bash"
for tool in bspline2mesh refine evolve navierstokes measure qualityreport export-svg export-gltf; do has_tool "$tool" || exit 77; done
for program in make python3; do command -v "$program" >/dev/null || exit 77; done
cylinder=$SOURCE/samples/cylinder bubble=$SOURCE/samples/bubble drop=$SOURCE/samples/drop tube=$SOURCE/samples/tube

run 0 make -C "$cylinder" out="$PWD/cylinder" DEGREE=3 SPANS=48 BOUNDS='2e-3 1e-3 1e-3'
grep -q '^ok .*drag 5.5' out || fail "cylinder: $(cat out)"
[ -s cylinder/picture.svg ] || fail "cylinder makes no picture"
run 1 "$cylinder/check-forces" cylinder 1e-12 1e-12 1e-12
grep -q '^FAILED drag' out || fail "check-forces does not see an error: $(cat out)"

# The commands of its README, as they are printed.
mkdir -p common printed
cp "$SOURCE/samples/common/boundary.py" common
cp "$cylinder/make-channel" "$cylinder/steady.json" printed
sed -n '/^    \.\/make-channel/,/^$/p' "$cylinder/README.md" >printed/commands
(cd printed && bash -e -o pipefail commands >forces.csv) || fail "the commands in the README of cylinder"
grep -q 'drag,lift,difference$' printed/forces.csv || fail "the commands in the README of cylinder print no forces"

run 0 make -C "$bubble" out="$PWD/bubble" SPANS=32 COARSEST=0.15 UNTIL=0.1 DT=0.02 EVERY=5 STILLS='0 0.1' bubble
for file in bubble.csv bubble.svg picture.svg; do [ -s "bubble/$file" ] || fail "bubble makes no $file"; done

run 0 make -C "$drop" out="$PWD/rest" RUN=rest SPANS=16 WALL=10 UNTIL=3
python3 - rest/steps.csv <<'EOP' || fail "a round drop does not stay at rest: $(tail -n 1 rest/steps.csv)"
import csv, sys
rows = list(csv.DictReader(open(sys.argv[1])))
sys.exit(not rows or any(float(row["navierstokes.max_speed"]) > 1e-11 for row in rows))
EOP
run 0 make -C "$drop" out="$PWD/relax" RUN=relax SPANS=16 WALL=10 DT=0.1
python3 - relax/drop.csv <<'EOP' || fail "an ellipse does not become round: $(tail -n 1 relax/drop.csv)"
import csv, math, sys
rows = list(csv.DictReader(open(sys.argv[1])))
rate = math.log(float(rows[9]["drop_deformation"]) / float(rows[19]["drop_deformation"])) / (float(rows[19]["time"]) - float(rows[9]["time"]))
print(rate)
sys.exit(abs(rate - 0.5) > 0.03)
EOP

run 0 make -C "$tube" out="$PWD/tube" CRITERIA='--max-turning 60' UNTIL=0.3 DT=0.03 EVERY=5 STILLS='0 0.3'
grep -q '^ok .*what enters leaves' out || fail "tube: $(cat out)"
for file in picture.svg tube.svg tube.glb; do [ -s "tube/$file" ] || fail "tube makes no $file"; done
# Problems stand in the READMEs as they are in the files.
for problem in "$cylinder/steady.json" "$bubble/bubble.json" "$drop/shear.json" "$tube/tube.json"; do
  sed -n '/^```json$/,/^```$/{/^```/d;p}' "${problem%/*}/README.md" >shown.json
  same shown.json "$problem"
done
finish
