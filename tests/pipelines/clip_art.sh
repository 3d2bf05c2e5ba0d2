#!/usr/bin/env bash
# Drawings of many hands: twelve of Debian's openclipart-svg, from the drawing to a mesh whose every element is valid.
. "${BASH_SOURCE%/*}/common.bash"
{ has_tool import-svg && has_tool bspline2mesh && has_tool qualityreport; } || exit 77
folder=/usr/share/openclipart/svg
[ -d "$folder" ] || { echo "openclipart-svg is missing" >&2; exit 77; }

while read -r drawing; do
  run 0 timeout 60 import-svg -q --planar "$folder/$drawing" -o boundary.json
  run 0 timeout 60 bspline2mesh -q boundary.json -o mesh.json
  run 0 qualityreport -q --fail-if 'invalid > 0' --fail-if 'faults > 0' --fail-if 'overlaps > 0' mesh.json
done <<'END'
signs_and_symbols/flags/europe/united_kingdom/united_kingdom.svg
computer/icons/flat-theme/action/htmlvalidator.svg
signs_and_symbols/map_symbols/aiga_fire_extinguisher_.svg
signs_and_symbols/flags/the_official_flag_of_i_r.svg
signs_and_symbols/elder_sign_nurbldoff_03r.svg
tools/pan_frouke_01.svg
signs_and_symbols/map_symbols/hill_-_rpg_map_elements_03.svg
computer/icons/people_juliane_krug_07c.svg
recreation/music/45_rpm_record_gerald_g._03.svg
office/box_with_folders_nicu_bu_01.svg
animals/mammals/echidna_01.svg
animals/2_dead_frogs_lumen_desig_01.svg
END
finish
