#!/usr/bin/env bash
# import-msh, and qualityreport on MSH files: from files and pipes, options, messages, statuses.
. "${BASH_SOURCE%/*}/common.bash"
has_tool import-msh || exit 77

# Two triangles of order 2 in a unit square, the second one in a group of its own, bent below.
cat >square.msh <<'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 1 "lower"
2 2 "upper one"
$EndPhysicalNames
$Nodes
9
1 0 0 3
2 1 0 3
3 1 1 3
4 0 1 3
5 0.5 -0.125 3
6 1 0.5 3
7 0.5 1 3
8 0 0.5 3
9 0.5 0.5 3
$EndNodes
$Elements
4
11 15 2 0 1 1
12 8 2 0 7 1 2 5
13 9 2 1 1 1 2 3 5 6 9
14 9 2 2 2 1 3 4 9 7 8
$EndElements
END

run 0 import-msh square.msh
silent
cp out square.json
for text in '"degree":2' '"name":"lower"' '"name":"upper one"' '"name":"curve 7"' '0.5,-0.25,'; do
  grep -qF -- "$text" square.json || fail "no $text in the mesh: $(head -c 400 square.json)"
done
run 0 import-msh -q <square.msh
silent
same out square.json
run 0 passthrough square.json
same out square.json
run 0 bash -c 'cat square.msh | import-msh -q - -o piped.json'
same piped.json square.json
run 0 import-msh -v square.msh
says 'triangles 0 to 1 are elements 13 to 14'
says '1 point (type 15) is left out'
(($(grep -c 'type 15' err) == 1)) || fail "it is said once: $(cat err)"
run 0 import-msh -q --report report.json --field u=x+y --field p@lower=t --time 2.5 square.msh
grep -qF '"time":2.5' out || fail "the time is set"
grep -qF '"name":"u","components":1' out || fail "a field is made"
grep -qF '1 point (type 15) is left out' report.json || fail "the report says what was left out: $(cat report.json)"
if has_tool qualityreport; then
  run 0 qualityreport -v square.msh
  says 'qualityreport: square.msh: 1 point (type 15) is left out'
fi
run 2 import-msh --field u= square.msh
run 2 import-msh --time soon square.msh
run 2 import-msh -q --field u@nowhere=1 square.msh

# qualityreport says of an MSH file what it says of its document, from a file or a pipe.
if has_tool qualityreport; then
  run 0 qualityreport -q --format json square.json
  cp out expected
  run 0 qualityreport -q --format json square.msh
  same out expected
  run 0 bash -c 'cat square.msh | qualityreport -q --format json'
  same out expected
  run 1 qualityreport --fail-if 'triangles < 3' square.msh
  says 'square.msh: frame 0: triangles < 3: it is 2'
fi

# Clockwise triangles are counted, and turned on request.
sed -e 's/ 1 2 3 5 6 9$/ 1 3 2 9 6 5/' -e 's/ 1 3 4 9 7 8$/ 1 4 3 8 7 9/' square.msh >clockwise.msh
run 0 import-msh clockwise.msh
says '2 of 2 triangles run clockwise (first: element 13); import-msh --orient turns whole parts that do'
run 0 import-msh --orient clockwise.msh
says '2 triangles turned'
if has_tool qualityreport; then
  run 1 qualityreport -q --fail-if 'invalid > 0' clockwise.msh
  run 0 bash -c 'import-msh -q --orient clockwise.msh | qualityreport --fail-if "invalid > 0"'
fi

# Triangles that do not fit together are audited, but make no document.
sed -e 's/^14 9 2 2 2 1 3 4/14 9 2 2 2 3 1 4/' square.msh >unfit.msh
run 3 import-msh unfit.msh
no_output
says 'import-msh: unfit.msh: the triangles do not make a mesh (qualityreport audits such a file)'
says 'element 1'
! grep -q 'triangle [0-9]' err || fail "elements have the numbers of the file: $(cat err)"
if has_tool qualityreport; then
  run 0 qualityreport unfit.msh
  run 1 qualityreport -q --fail-if 'faults > 0' unfit.msh
fi

# Bad files.
for tool in import-msh qualityreport; do
  has_tool "$tool" || continue
  head -n 20 square.msh >short.msh
  run 3 "$tool" short.msh
  no_output
  says "$tool: short.msh: line 21: "
  sed 's/^6 1 0.5 3/6 1 nan 3/' square.msh >nan.msh
  run 3 "$tool" - <nan.msh
  says "$tool: standard input: line 16: node 6: expected three finite coordinates"
  sed '/^1[34] /d; s/^4$/2/' square.msh >empty.msh
  run 3 "$tool" empty.msh
  says 'the file has no triangles; it has 1 point (type 15)'
  { head -n 3 square.msh; head -c 100000 /dev/urandom; } >rubbish.msh
  run 3 "$tool" rubbish.msh
  run 5 "$tool" no-such-file.msh
done
run 3 import-msh disk.json
says 'import-msh: disk.json: this is a mesh, which '
run 3 import-msh </dev/null
says 'import-msh: standard input:1: the input is empty'
run 3 import-msh -o never.json short.msh
[ ! -e never.json ] || fail "a failure leaves a file"

# A mesh is exported in every format, from a file or a pipe, and imported again.
if has_tool export-msh; then
  for format in msh41 msh22; do
    for binary in '' --binary; do
      run 0 export-msh --format $format $binary square.json
      silent
      cp out back.msh
      run 0 bash -c "export-msh --format $format $binary - <square.json | cmp back.msh"
      run 0 import-msh back.msh
      silent
      for text in '"degree":2' '"name":"lower"' '"name":"upper one"' '"name":"curve 7"' '0.5,-0.25,'; do
        grep -qF -- "$text" out || fail "no $text in the mesh that came back: $(head -c 400 out)"
      done
    done
  done
  run 0 export-msh square.json
  head -n 2 out | grep -qx '4.1 0 8' || fail "text of version 4.1 is the default"
  cat square.json disk.json >series.jsonl
  run 0 export-msh -q --frame -1 series.jsonl
  cp out last.msh
  run 0 export-msh disk.json
  same out last.msh
  run 2 export-msh --frame 2 series.jsonl
  says 'has 2 meshes'
  no_output
  run 2 export-msh --format msh1 square.json
  run 0 export-msh -q tangled.json
  run 0 export-msh square.msh

  # Fields and the time go along. Values at nodes of a quadratic polynomial give it back.
  run 0 import-msh -q --time 0.5 --field u=x*y --field v=x,-y --field p@lower=3 square.msh -o fields.json
  for format in msh41 msh22; do
    for binary in '' --binary; do
      run 0 export-msh --format $format $binary fields.json -o fields.msh
      silent
      run 0 import-msh fields.msh
      silent
      for text in '"time":0.5,' '"name":"u","components":1' '"name":"v","components":2' '"name":"p","components":1,"by_face":true'; do
        grep -qF -- "$text" out || fail "no $text in the mesh that came back: $(head -c 2000 out)"
      done
      cp out again.json
      run 0 export-msh --format $format $binary again.json -o fields.msh
      run 0 import-msh --time 2 fields.msh
      grep -qF '"time":2,' out || fail "--time is stronger than the file"
      sed 's/"time":2,/"time":0.5,/' out >second.json
      same second.json again.json
    done
  done
  run 0 import-msh -q --field m=1,2,3,4 square.msh -o many.json
  run 0 export-msh many.json
  says 'export-msh: the field m has 4 components, and Gmsh knows 1, 3 and 9: each is written as a view of its own'
  (($(grep -c '^\$NodeData' out) == 4)) || fail "four views"
fi

# Of several time steps one is read.
steps() {
  for k in 0 1 2; do
    printf '$NodeData\n1\n"u"\n1\n%s.5\n3\n%s\n1\n9\n' $k $k
    for node in 1 2 3 4 5 6 7 8 9; do echo "$node $k"; done
    echo '$EndNodeData'
  done
}
{ cat square.msh; steps; } >steps.msh
run 0 import-msh steps.msh
says 'import-msh: steps.msh: the view u has 3 time steps: the first is read, of time 0.5; import-msh --step takes another'
grep -qF '"values":[0,0,' out || fail "the first step is the default"
run 0 import-msh --step -1 steps.msh
silent
grep -qF '"values":[2,2,' out || fail "the last step is read"
grep -qF '"time":2.5,' out || fail "its time is read"
run 2 import-msh --step 3 steps.msh
says 'steps.msh: the view u has 3 steps, and --step asks for step 3'
no_output
run 2 import-msh --step soon steps.msh
sed 's/^5 1$/5 nan/' steps.msh >nan.msh
run 0 import-msh -q nan.msh
run 3 import-msh --step 1 nan.msh
says 'import-msh: nan.msh: line 60: $NodeData, node 5: expected finite values up to 1e300'
finish
