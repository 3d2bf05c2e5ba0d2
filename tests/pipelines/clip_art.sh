#!/usr/bin/env bash
# Drawings of many hands: twenty of Debian's openclipart-svg, from the drawing to a mesh whose every element is valid.
# Most have what is hard: borders that two shapes share but do not cut alike, corners whose sides cross beside them,
# hairpins that no span can follow, long curves tangent to short ones. tests/bench/clipart runs them all.
. "${BASH_SOURCE%/*}/common.bash"
{ has_tool import-svg && has_tool bspline2mesh && has_tool qualityreport; } || exit 77
folder=/usr/share/openclipart/svg
[ -d "$folder" ] || { echo "openclipart-svg is missing" >&2; exit 77; }

while read -r drawing; do
  run 0 timeout 60 import-svg -q --planar "$folder/$drawing" -o boundary.json
  run 0 timeout 60 bspline2mesh -q boundary.json -o mesh.json
  run 0 qualityreport -q --fail-if 'invalid > 0' --fail-if 'faults > 0' --fail-if 'overlaps > 0' mesh.json
done <<'END'
animals/2_dead_frogs_lumen_desig_01.svg
animals/mammals/coniglio_architetto_fran_01.svg
computer/bb_cd_.svg
computer/finestra_hz_architetto_f_01.svg
computer/icons/flat-theme/action/cdinfo.svg
computer/icons/flat-theme/action/filterstop.svg
computer/icons/flat-theme/action/htmlvalidator.svg
computer/icons/flat-theme/applications/gxmessage.svg
computer/user_frederic_moser_01.svg
education/books/newspaper_aubanel_monnie_01.svg
office/inservice_presentation_01.svg
plants/flowers/red_flower_raphael_seban_01.svg
recreation/games/cards/ornamental/ornamental_c_7.svg
recreation/religion/creation_day_7_number_ge_04.svg
science/medicine/barattolo_di_pillole_arc_01.svg
shapes/arrows/arrow11_2.svg
signs_and_symbols/elder_sign_nurbldoff_03r.svg
signs_and_symbols/flags/europe/united_kingdom/united_kingdom.svg
transportation/roadsigns/grounded.svg
unsorted/calzettoni.svg
END
finish
