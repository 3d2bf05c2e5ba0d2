#!/usr/bin/env bash
# smoothcurves --global: its options, what it leaves, its licence, and the build without Ceres.
. "${BASH_SOURCE%/*}/common.bash"
has_tool smoothcurves || exit 77

# The build without Ceres refuses --global with a clear message, and does everything else.
run 2 smoothcurves_without_ceres --global disk.json
no_output
says 'built without the global smoother'
run 0 smoothcurves_without_ceres disk.json
same out disk.json
run 0 smoothcurves_without_ceres --version
if grep -q GPL out || grep -q 'General Public' out; then fail "a licence that is not needed: $(cat out)"; fi

# Nor has evolve it, whose steps are run in one process: it names the tool that has.
if has_tool evolve; then
  run 2 evolve 'smoothcurves --global' --steps 1 disk.json
  no_output
  says 'smoothcurves has it'
fi

smoothcurves --version | grep -q 'General Public License' || exit 77  # this build is without, too
for option in '--good 0' '--good 1.1' '--good nan' '--rings -1'; do
  run 2 smoothcurves --global $option disk.json
  no_output
done
for option in '--good 0.5' '--rings 2'; do
  run 2 smoothcurves $option disk.json
  says '--global'
done

for option in '--split' '--flips' '--measure control' '--max-sweeps 3' '--max-turning 50'; do
  # shellcheck disable=SC2086
  run 2 smoothcurves --global $option disk.json
  says '--global'
done

# A mesh without poor elements stays the same byte for byte.
run 0 smoothcurves --global --good 0.01 disk.json
silent
same out disk.json

# A step that was too long is mended by edges alone, and with vertices. (The step leaves the boundary of the disk in
# order.)
for tool in advect qualityreport refine; do has_tool "$tool" || exit 77; done
refine --max-area 0.01 disk.json >fine.json
flow='max(0,1-x^2-y^2)^2*0.06'
advect --vx="-($flow)*cos(20*x)*sin(20*y)" --vy="($flow)*sin(20*x)*cos(20*y)" --dt 3 --force fine.json >far.json 2>/dev/null
run 0 smoothcurves --global --report report.json far.json
cp out smooth.json
run 0 qualityreport --fail-if 'invalid > 0' smooth.json
for name in iterations energy_before energy_after points_moved elements_smoothed before after; do
  grep -q "\"$name\"" report.json || fail "no $name in the report: $(cat report.json)"
done
run 0 smoothcurves --global --vertices far.json
cp out smooth.json
run 0 qualityreport --fail-if 'invalid > 0' smooth.json

# Where --global would have done better, -v and the report say so, with figures that --global then reaches.
flow='max(0,1-x^2-y^2)*0.12'
advect --vx="-($flow)*cos(10*x)*sin(10*y)" --vy="($flow)*sin(10*x)*cos(10*y)" --dt 1 --force fine.json >bent.json 2>/dev/null
smoothcurves -v --report report.json -o local.json bent.json 2>err || fail 'the bent mesh'
word='--global in place of the local smoother does better: 0 elements not valid, least scaled Jacobian '
grep -q -e "$word" err || fail "nothing is said of --global: $(cat err)"
grep -q -e "$word" report.json || fail 'nothing is said of --global in the report'
said=$(grep -o -e "$word[0-9.]*" err | head -n 1 | grep -o '[0-9.]*$')
smoothcurves --global -o global.json bent.json
[ "$(qualityreport -q --format json global.json | python3 -c '
import json, sys
print("%.4g" % json.load(sys.stdin)["scaled_jacobian"]["min"])')" = "$said" ] || fail "--global does not reach $said"
smoothcurves_without_ceres -v -o absent.json bent.json 2>err
if grep -q -e --global err; then fail 'a build without the global smoother recommends it'; fi
# Where nothing is left to do, nothing is said of --global.
smoothcurves -v -o absent.json disk.json 2>err
if grep -q -e --global err; then fail 'advice where nothing is left'; fi

# What no motion mends is meshed anew, unless the mesh is wanted as it is.
sample_mesh tangled 1 >stuck.json
if ! qualityreport --fail-if 'invalid > 0' stuck.json >/dev/null 2>&1; then
  run 0 smoothcurves --global --keep-going stuck.json
  cp out kept.json
  if qualityreport --fail-if 'invalid > 0' kept.json >/dev/null 2>&1; then fail 'motion alone mends it'; fi
  run 0 smoothcurves --global --report report.json stuck.json
  cp out smooth.json
  run 0 qualityreport --fail-if 'invalid > 0' smooth.json
  grep -Eq '"patches_remeshed": ?[1-9]' report.json || fail 'nothing was meshed anew'
fi

# Ceres is in this tool alone.
if command -v ldd >/dev/null; then
  for tool in "${built[@]}"; do
    [ "$tool" = smoothcurves ] && continue
    if ldd "$(command -v "$tool")" | grep -Eq 'ceres|glog|cholmod'; then fail "$tool links Ceres"; fi
  done
fi
finish
