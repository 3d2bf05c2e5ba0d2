#!/usr/bin/env bash
# Bad input ends with status 3, names the place, and writes nothing.
. "${BASH_SOURCE%/*}/common.bash"

# edit FROM TO: disk.json with the first FROM replaced, as bad.json.
edit() {
  python3 - "$1" "$2" <<'PYTHON'
import sys
text = open("disk.json").read()
assert sys.argv[1] in text, sys.argv[1]
open("bad.json", "w").write(text.replace(sys.argv[1], sys.argv[2], 1))
PYTHON
}
# refused MESSAGE: every mesh filter refuses bad.json and says so.
refused() {
  local tool
  for tool in "${mesh_filters[@]}"; do
    run 3 filter "$tool" bad.json
    no_output
    says "$tool: bad.json:1: frame 0: $1"
  done
}

edit '"degree":2,"time"' '"degree":99,"time"'; refused '/degree: '
edit '"version":1' '"version":7'; refused '/version: '
edit 'pliant-mesh' 'pliant-mush'; refused '/format: '
edit '"points":[0,' '"points":[nan,'; refused '/points/0: '
edit '"points":[0,' '"points":[1e999,'; refused '/points/0: '
edit '"points":[0,' '"points":['; refused '/points: '
edit '"triangles":[0,' '"triangles":[100000,'; refused '/triangles/0: '
edit '"triangles":[0,' '"triangles":[0.5,'; refused '/triangles/0: '
edit '"triangle_faces":[0,' '"triangle_faces":[1,'; refused '/triangle_faces/0: '
edit '"span":1,' '"span":1,"span":1,'; refused '/constrained_edges/1: '
edit '"name":"u"' '"name":u'; refused '/fields/0/name: '
edit '"knots":[0,' '"knots":[5,'; refused '/boundary/curves/0/knots/1: '
edit '"step":7' '"step":07'; refused '/step: '
edit '"step":7}' '"step":7}}'; refused ''

# Structure: a triangle that no longer shares its control points, a curve that left its edges.
edit '"triangles":[0,' '"triangles":[1,'; refused ''
python3 - <<'PYTHON'
import json
mesh = json.load(open("disk.json"))
mesh["boundary"]["curves"][0]["points"][0] += 0.25
open("bad.json", "w").write(json.dumps(mesh))
PYTHON
refused '/'
says '(M4)'

# Text that is no JSON, and its line.
head -c 500 disk.json >bad.json; refused ''
printf 'not json\n' >bad.json; refused 'should be an object'
says "should be an object, found 'n'"
printf '{\n "format": "pliant-mesh",\n "version" 1}\n' >bad.json
run 3 passthrough bad.json
says 'passthrough: bad.json:3: frame 0: '
says 'column 12'

# An empty input stops a pipe.
: >bad.json
for tool in "${mesh_filters[@]}"; do
  run 3 filter "$tool" bad.json
  no_output
  says "$tool: bad.json:1: the input is empty"
  run 3 filter "$tool" </dev/null
  says "$tool: standard input:1: the input is empty"
done
run 3 bash -c 'set -o pipefail; passthrough --stop-at 0 disk.json | passthrough'

# Boundaries, for the tool that reads them.
if has_tool bspline2mesh; then
  run 3 bspline2mesh disk.json
  says 'bspline2mesh: disk.json:1: frame 0: /format: '
  run 3 bspline2mesh </dev/null
fi

# A mesh is told to be one by the tools that read none, which the message names, and by no other.
for tool in "${built[@]}"; do
  "$tool" disk.json >out 2>err
  case $tool in
    bspline2mesh | import-*) says 'this is a mesh, which all tools but bspline2mesh and import-* read' ;;
    *) ! grep -qF 'this is a mesh' err || fail "$tool reads no mesh, but the message says that it does: $(cat err)" ;;
  esac
done

# A tangled mesh: refused with the count, the first elements and what helps, or taken.
for tool in "${mesh_filters[@]}"; do
  if [ "$tool" = smoothcurves ]; then continue; fi
  run 3 filter "$tool" tangled.json
  no_output
  says "$tool: tangled.json:1: frame 0: /triangles/"
  says 'smoothcurves'
done
run 0 passthrough --tangled tangled.json
same out tangled.json

# A bad frame of a series: the frames before it stay, the place names frame and line.
{ head -n 2 series.jsonl; echo '{"format":"pliant-mesh"}'; tail -n 1 series.jsonl; } >bad.jsonl
for tool in "${mesh_filters[@]}"; do
  run 3 filter "$tool" bad.jsonl
  says "$tool: bad.jsonl:3: frame 2: lacks the member"
  (($(wc -l <out) == 2)) || fail "$tool: the frames before the bad one should stay"
  filter "$tool" <(head -n 2 series.jsonl) >two.jsonl
  same out two.jsonl
done
finish
