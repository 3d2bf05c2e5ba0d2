#!/usr/bin/env bash
# export-svg from the outside: formats by name and option, equal bytes, themes, layers, isolines, arrows, wrong usage.
. "${BASH_SOURCE%/*}/../common.bash"
has_tool export-svg || exit 77

sample_mesh disk 3 0 >disk.json
head -c 2000 disk.json >cut.json

# signed FILE BYTES: the file begins with these bytes, given in hexadecimal.
signed() { [ "$(head -c "$((${#2} / 2))" "$1" | od -An -tx1 | tr -d ' \n')" = "$2" ] || fail "$1 does not begin with $2"; }
png=89504e470d0a1a0a
pdf=255044462d

if export-svg --format png disk.json >/dev/null 2>err || ! grep -q 'built without librsvg' err; then
  # Two runs, in different seconds and folders, give the same bytes.
  for format in png pdf; do
    run 0 export-svg --color field:u --axes --title 'A title' --width 321 disk.json -o "first.$format"
    silent
    sleep 1.1
    mkdir -p "elsewhere-$format"
    (cd "elsewhere-$format" && SOURCE_DATE_EPOCH=5 export-svg --color field:u --axes --title 'A title' --width 321 ../disk.json -o second) 2>err
    run 0 export-svg --color field:u --axes --title 'A title' --width 321 --format "$format" disk.json
    same out "first.$format"
    ! grep -aq CreationDate "first.$format" || fail "a date in first.$format"
  done
  signed first.png $png
  signed first.pdf $pdf
  # Width and height of a PNG are at offsets 16 and 20.
  [ "$(head -c 20 first.png | tail -c 4 | od -An -tx1 | tr -d ' ')" = 00000141 ] || fail "first.png is not 321 pixels wide"
  run 0 export-svg disk.json -o LOUD.PNG
  signed LOUD.PNG $png
  run 0 export-svg --format svg disk.json -o named.png
  grep -q '^<svg' named.png || fail "--format does not go before the name"
  run 4 export-svg --width 40000 disk.json -o never.png
  says 'export-svg: a PNG of 40000 by '
  says 'at most 32767'
  [ ! -e never.png ] || fail "never.png is there"
  run 3 export-svg cut.json -o never.pdf
  [ ! -e never.pdf ] || fail "never.pdf is there"
fi

for theme in light dark print; do
  run 0 export-svg --theme $theme --color field:u --isolines u=3 --isolines u=0.1,0.2 --scale-bar --unit mm --axes \
    --layer logical-mesh --layer control-net disk.json
  silent
  for name in axes keys scale-bar isolines isoline logical-mesh control-net legend; do
    grep -q "class=\"$name\"" out || fail "--theme $theme: no $name"
  done
done
run 0 export-svg --control-net disk.json
cp out net.svg
run 0 export-svg --layer control-net disk.json
same net.svg out

# What has no room is left out, with a word.
run 0 export-svg --width 50 --axes --title Title disk.json
says 'export-svg: the legend is too wide for a picture 50 pixels wide, and left out'
says 'the axes are too wide'
run 0 export-svg -q --width 50 --axes --title Title disk.json
silent

# refuses TEXT OPTION...: wrong usage, whose message holds the text.
refuses() {
  local text=$1
  shift
  run 2 export-svg "$@" disk.json
  says "$text"
  no_output
}
refuses "--format: 'jpeg' is none of svg, png, pdf" --format jpeg
refuses 'pictures are svg, png or pdf, not jpg' -o a.JPG
[ ! -e a.JPG ] || fail 'a file of a format that is not written'
refuses 'is wider than' --box=-1e308,-1e308,1e308,1e308
refuses 'is wider than' --circle 1.7e308,0,1e308
refuses 'pixels high' --box=0,0,1,1e9
refuses 'pixels high' --axes --box=0,0,1,1e9

# However tall a picture is, its axis has a thousand labels or so.
run 0 export-svg --color none --axes --box=-1,-4000,1,4000 disk.json
[ "$(wc -c <out)" -lt 1000000 ] || fail "the axis of a tall picture takes $(wc -c <out) bytes"

# What lies outside of the box is not in the picture, so that one from near takes no longer.
run 0 export-svg --color face --isolines u=5 --box 0.1,0.1,0.11,0.11 disk.json
near=$(wc -c <out)
run 0 export-svg --color face --isolines u=5 disk.json
((near < $(wc -c <out) / 2)) || fail "a picture of a hundredth has $near bytes"
refuses "--theme: 'neon' is none of light, dark, print" --theme neon
refuses "--layer: 'mesh' is none of control-net, logical-mesh" --layer mesh
refuses "--isolines: the mesh has no field 'heat'" --isolines heat
refuses "'0' is not a whole number from 1 to 1000" --isolines u=0
refuses "there is no number behind '='" --isolines u=
refuses "'x'" --isolines u=1,x
refuses "'nan'" --isolines u=nan,
refuses "FIELD or FIELD:N is wanted" --arrows :5
refuses "'501' is not a whole number from 1 to 500" --arrows u:501
refuses "--arrows: the mesh has no field 'u' of two components" --arrows u
refuses "--scale 0.01: from 0.1 to 100" --scale 0.01
finish
