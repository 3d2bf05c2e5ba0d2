#!/usr/bin/env bash
# A circle in the reversed vortex, as in samples/vortex: the accuracy asked for is kept, and errors fall with order p + 1.
. "$(dirname "${BASH_SOURCE[0]}")/../common.bash"
for tool in bspline2mesh evolve vortex-errors; do command -v "$tool" >/dev/null || exit 77; done
command -v python3 >/dev/null || exit 77

step='advect --flow reversed-vortex:period=8 --dt 0.08 --substeps 8 | flipdelaunay | refine | coarsen | smoothcurves'
# simulate DEGREE ACCURACY: leaves DEGREE-ACCURACY.errors, a line of JSON a frame, and DEGREE-ACCURACY.csv, a line a step.
simulate() {
  local name=$1-$2
  "$SOURCE/samples/vortex/make-start" "$1" "$2" | bspline2mesh -q --degree "$1" --accuracy "$2" -o start.json
  run 0 evolve -q --until 8 --at 4,8 -o frames.jsonl --history "$name.csv" "$step" start.json
  vortex-errors frames.jsonl 1000 4,8 >"$name.errors"
}
simulate 2 1.6e-4
simulate 2 2e-5
simulate 3 3.2e-5
simulate 3 2e-6

cat >check.py <<'EOP'
import csv, json, math, sys

failed = 0


def check(holds, text):
    global failed
    failed += not holds
    print("ok    " if holds else "FAIL:", text, file=sys.stderr)


def errors_of(degree, accuracy):
    """Checks one run; returns its error at T/2."""
    name = f"{degree}-{accuracy}"
    frames = {row["time"]: row for row in map(json.loads, open(name + ".errors"))}
    steps = list(csv.DictReader(open(name + ".csv")))
    total = lambda column: sum(float(step[column]) for step in steps)
    half, end, bound = frames[4], frames[8], float(accuracy)
    check(min(float(step["min_scaled_jacobian"]) for step in steps) > 0, name + ": every step is valid")
    check(half["interface"] <= bound, f"{name}: interface at T/2 within {half['interface']}")
    check(end["circle"] <= bound / 2, f"{name}: {end['circle']} off the circle at T")
    check(abs(end["drift"]) <= bound, f"{name}: drift {end['drift']}")
    for column in ("refine.curve_splits", "coarsen.curve_removals", "flipdelaunay.flips"):
        check(total(column) > 100, f"{name}: {column} {total(column):.0f}")
    check(end["spans"] < half["spans"], f"{name}: {half['spans']} spans at T/2, {end['spans']} at T")
    return half["interface"]


# From one run to the other sizes are halved.
for degree, coarse, fine in ((2, "1.6e-4", "2e-5"), (3, "3.2e-5", "2e-6")):
    order = math.log2(errors_of(degree, coarse) / errors_of(degree, fine))
    check(order > degree + 0.4, f"degree {degree}: order {order:.2f}")
sys.exit(failed > 0)
EOP
python3 check.py || fail 'the errors are not what the accuracy asks for'
finish
