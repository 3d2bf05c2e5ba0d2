#!/usr/bin/env bash
# Documents in CBOR and compressed ones: the same results by every tool, and the way back to the same bytes of JSON.
. "${BASH_SOURCE%/*}/../common.bash"
examples=$SOURCE/samples/examples
decode() { python3 "$SOURCE/tests/support/cbor.py"; }

run 0 passthrough --to cbor series.jsonl -o series.cbor
silent
decode <series.cbor >decoded.jsonl || fail 'another decoder does not read the series'
run 0 passthrough series.cbor --to json
same out series.jsonl
run 0 passthrough decoded.jsonl
same out series.jsonl
gzip -c series.cbor >series.gz
gzip -c series.jsonl | tee -a twice.gz twice.gz >/dev/null
for tool in "${mesh_filters[@]}"; do
  filter "$tool" series.jsonl >plain.jsonl
  run 0 filter "$tool" series.cbor
  mv out told.cbor
  run 0 passthrough --to json told.cbor
  same out plain.jsonl
  run 0 filter "$tool" --to json series.gz
  same out plain.jsonl
done
cat series.jsonl series.cbor >mixed
run 0 passthrough --to json mixed
same out <(cat series.jsonl series.jsonl)

# What no tool knows comes back as it was.
members='"n":null,"big":18446744073709551615,"least":-9223372036854775808,"zero":-0.0,"x":[1,2.5,"\u00e9",{"a":[]},true]'
sed "1s/^{/{$members,/" disk.json >other.json
run 0 passthrough other.json -o canonical.json
run 0 passthrough canonical.json --to cbor -o other.cbor
run 0 passthrough other.cbor --to json
same out canonical.json

# Damage has a place.
head -c 1000 series.cbor >cut.cbor
run 3 passthrough cut.cbor
says 'passthrough: cut.cbor: frame 0: '
says '(byte 9'
head -c 200 series.gz >cut.gz
run 3 passthrough cut.gz
says 'cut.gz'
if has_tool bspline2mesh && has_tool evolve; then
  run 0 bspline2mesh --no-refine --to cbor "$examples/disk.json" -o disk.cbor
  bspline2mesh --no-refine "$examples/disk.json" >disk-plain.json
  run 0 passthrough --to json disk.cbor
  same out disk-plain.json
  step='advect --dt 0.01 --vx 1 --vy 0 | flipdelaunay'
  evolve "$step" --steps 3 --every 1 disk-plain.json -o plain.jsonl
  run 0 evolve "$step" --steps 3 --every 1 disk.cbor -o run.cbor
  run 0 passthrough --to json run.cbor
  same out plain.jsonl
  run 0 evolve "$step" --steps 1 --every 1 disk.cbor -o short.cbor
  run 0 evolve "$step" --steps 3 --every 1 disk.cbor -o short.cbor --resume
  same short.cbor run.cbor
  run 0 evolve "$step" --steps 3 --every 1 disk-plain.json --to cbor --frames 'frame-%02d.cbor'
  cat frame-0?.cbor >frames.cbor
  same frames.cbor run.cbor
fi

# Completion finds the same names in either form.
if has_tool import-svg && has_tool bspline2mesh && has_tool diffuse; then
  for form in json cbor; do
    import-svg -q --planar --to $form "$examples/drawing.svg" >drawing.$form
    bspline2mesh --complete-value --face-area '' drawing.$form >faces.$form
    bspline2mesh -q --no-refine drawing.json | sed "s/^{/{\"problem\":$(tr -d '\n' <"$examples/heat.json" | sed 's/[&/\\]/\\&/g'),/" |
      passthrough --to $form >mesh.$form
    diffuse --complete-value --set '' mesh.$form >parameters.$form
  done
  grep -q pond faces.json && grep -q = parameters.json || fail 'completion finds no names in JSON'
  same faces.cbor faces.json
  same parameters.cbor parameters.json
fi

# Which tool reads what this one does not.
if has_tool bspline2mesh && has_tool advect; then
  run 3 filter advect "$examples/drawing.svg"
  says 'this is an SVG drawing: import-svg makes a boundary of it, bspline2mesh a mesh of that'
  run 3 filter advect "$examples/disk.json"
  says 'bspline2mesh makes a mesh'
  passthrough --to cbor disk.json -o mesh.cbor
  run 3 bspline2mesh mesh.cbor
  says 'this is a mesh'
fi
finish
