#!/usr/bin/env bash
# import-svg: from drawings to meshes, options, messages, statuses.
. "${BASH_SOURCE%/*}/common.bash"
has_tool import-svg || exit 77

cat >cells.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 60">
  <path id="wall" fill-rule="evenodd" d="M2 2h96v56h-96z M10 30a20 20 0 1 1 40 0a20 20 0 1 1-40 0z" stroke="black"/>
  <ellipse id="cell" cx="30" cy="30" rx="14" ry="8" transform="rotate(30 30 30)"/>
</svg>
END
cat >letter.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg"><style>.ink{fill:black} .guide{fill:none}</style>
  <rect class="guide" width="40" height="60"/>
  <path class="ink" id="a" d="M20 5q18 0 18 25t-18 25t-18-25T20 5zM20 15q-9 0-9 15t9 15t9-15t-9-15z"/>
</svg>
END
cat >heart.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="50mm" height="50mm">
  <g transform="translate(50,50) scale(2)"><path id="heart" d="M0 20C-5 12-20 8-20-4S-3-17 0-6C3-17 20-16 20-4S5 12 0 20z"/></g>
  <use href="#heart" x="150" y="10"/>
</svg>
END

for drawing in cells letter heart; do
  for degree in 2 3; do
    run 0 import-svg --degree "$degree" "$drawing.svg"
    cp out "$drawing.json"
    if has_tool bspline2mesh && has_tool qualityreport; then
      run 0 bspline2mesh -q "$drawing.json" -o mesh.json
      run 0 qualityreport -q --fail-if 'invalid > 0' --fail-if 'faults > 0' --fail-if 'overlaps > 0' mesh.json
    fi
  done
done

# Files and pipes give the same bytes, and what is not read is said once.
run 0 import-svg cells.svg
says 'import-svg: cells.svg: strokes are not read (line 2)'
cp out cells.json
grep -qF '"faces":[{"name":"wall"},{"name":"cell"}]' cells.json || fail "faces by id: $(head -c 300 cells.json)"
run 0 import-svg -q <cells.svg
silent
same out cells.json
run 0 bash -c 'cat cells.svg | import-svg -q - -o piped.json'
same piped.json cells.json
run 0 import-svg -v --report report.json letter.svg
says 'shapes 1, faces 1, curves 2'
says 'unfilled 1, hidden 0'
grep -qF '"error":0' report.json || fail "quadratic curves are exact: $(cat report.json)"
run 0 import-svg heart.svg -o heart.json
run 0 import-svg -q --tolerance 1e-3 heart.svg
(($(wc -c <out) < $(wc -c <heart.json))) || fail "a greater tolerance takes fewer pieces"
run 2 import-svg --degree 4 cells.svg
run 2 import-svg --tolerance 0 cells.svg
run 2 import-svg --tolerance 1e-13 cells.svg
run 2 import-svg --report - cells.svg

# Strokes and clip paths.
cat >lines.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="100mm" viewBox="0 0 200 100">
  <clipPath id="left"><circle cx="60" cy="50" r="45"/></clipPath>
  <rect id="pond" x="10" y="10" width="180" height="80" clip-path="url(#left)"/>
  <g fill="none" stroke="black" stroke-width="4">
    <path id="wave" d="M0 50C20 20 40 80 60 50S90 20 120 60" stroke-linecap="round"/>
    <circle id="ring" cx="60" cy="50" r="20"/><path id="over" d="M30 30h30M50 30h20M40 30v20"/>
    <path id="touch" d="M40 20q20 20 40 0M60 30v-5" stroke-dasharray="9 3"/>
  </g>
</svg>
END
for kind in curves area; do
  for degree in 2 3; do
    run 0 import-svg --strokes $kind --degree $degree --tolerance 1e-4 --unit mm lines.svg -o lines.json
    if has_tool bspline2mesh && has_tool qualityreport; then
      run 0 bspline2mesh -q lines.json -o mesh.json
      run 0 qualityreport -q --fail-if 'invalid > 0' --fail-if 'faults > 0' --fail-if 'overlaps > 0' mesh.json
    fi
  done
done
run 0 import-svg --strokes curves lines.svg
says 'strokes run outside of all faces'
run 2 import-svg --strokes both lines.svg
run 2 import-svg --unit miles lines.svg
sed 's/<rect id="pond".*//' lines.svg >bare.svg
run 3 import-svg bare.svg
says 'which --strokes area reads as the area that it paints'
run 3 import-svg --strokes curves bare.svg
says 'curves of strokes only cut faces'
run 3 bash -c 'echo "<svg><path stroke=\"red\" d=\"M0 0H1e9\" stroke-dasharray=\".1\"/></svg>" | import-svg --strokes area'
says 'more than 100000 dashes'

# Bad files.
sed 's/a20 20 0 1 1 40 0/a20 20 0 2 1 40 0/' cells.svg >flag.svg
run 3 import-svg flag.svg
no_output
says "import-svg: flag.svg: line 2, column 3: path 'wall': d, offset 31: expected the flag 0 or 1, found '2 1 40 0a20 "
sed 's/cx="30"/cx="90"/' cells.svg >crossing.svg
run 3 import-svg crossing.svg
says "import-svg: crossing.svg: shapes cross, touch or lie over each other; import-svg --planar"
says "import-svg: crossing.svg: curve 'wall, line 2' (0) at parameter"
run 0 import-svg --planar -q crossing.svg --report report.json -o crossing.json
grep -qF '"intersections":2' report.json || fail "the cell crosses the wall twice: $(cat report.json)"
if has_tool bspline2mesh && has_tool qualityreport; then
  run 0 bash -c "bspline2mesh -q crossing.json | qualityreport -q --fail-if 'invalid > 0' --fail-if 'faults > 0'"
fi
head -c 200 cells.svg >short.svg
run 3 import-svg short.svg
says 'import-svg: short.svg: line 3, column '
run 3 import-svg disk.json
says 'import-svg: disk.json: this is a mesh, which '
run 3 import-svg </dev/null
says 'import-svg: standard input: the input is empty'
run 3 bash -c 'echo "<svg><path d=\"M0 0h1\"/></svg>" | import-svg'
says 'nothing is filled'
run 5 import-svg no-such-file.svg
run 5 import-svg .
run 3 import-svg -o never.json short.svg
[ ! -e never.json ] || fail "a failure leaves a file"
finish
