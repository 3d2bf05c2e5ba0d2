#!/usr/bin/env bash
# Each kind of fault in a boundary ends with status 3 and a message that names file, curves, parameters, coordinates
# and what would be right; what is unusual but sound is meshed.
. "${BASH_SOURCE%/*}/common.bash"
has_tool bspline2mesh || exit 77

python3 - <<'PYTHON'
import json

corners = [0, 0, 4, 0, 4, 4, 0, 4]
names = ["floor", "right wall", "ceiling", "left wall"]

def curve(name, points, start=None, end=None, left=None, right=None, degree=1, knots=None):
    n, closed = len(points) // 2, start is None
    if knots is None:
        knots = list(range(n + 1)) if closed else [0] * degree + list(range(n - degree + 1)) + [n - degree] * degree
    return {"name": name, "degree": degree, "closed": closed, "knots": knots, "points": points,
            "start": start, "end": end, "left": left, "right": right}

def side(i, left=0, right=None):
    a, b = i, (i + 1) % 4
    return curve(names[i], corners[2 * a:2 * a + 2] + corners[2 * b:2 * b + 2], a, b, left, right)

def disk(name, x, y, r, left, right):
    return curve(name, [x + r, y - r, x + r, y + r, x - r, y + r, x - r, y - r], left=left, right=right, degree=2)

def write(path, curves, faces=("room",), more_vertices=()):
    vertices = corners + list(more_vertices) if any(not curve["closed"] for curve in curves) else []
    text = json.dumps({"format": "pliant-boundary", "version": 1, "vertices": vertices,
                       "faces": [{"name": face} for face in faces], "curves": curves})
    open(path + ".json", "w").write(text)
    return text

walls = [side(i) for i in range(4)]
without_floor = walls[1:]
inner = ("room", "cell")

# Curves that meet.
write("figure_of_eight", [curve("eight", [0, 0, 2, 2, 2, 0, 0, 2], left=0)])
write("loop_in_a_span", walls[1:] + [curve("loop", [0, 0, 12, 3, -8, 3, 4, 0], 0, 1, 0, degree=3)])
write("crossing", walls + [disk("cell", 3.5, 2, 1, 1, 0)], inner)
write("through_a_vertex", walls + [curve("diamond", [4, 4, 5, 4, 5, 5, 4, 6], left=1)], inner)
write("overlap", walls + [curve("annex", [4, 1, 5, 1, 5, 3, 4, 3], left=1)], inner)
write("twice", walls + [disk("cell", 2, 2, 1, 1, 0), disk("again", 2, 2, 1, 1, 0)], inner)
write("folded", [curve("there", [0, 0, 4, 0], 0, 1, 0), curve("back", [4, 0, 2, 0, 0, 0], 1, 0, 0, degree=2)])
# Loops that do not close.
write("ends_nowhere", walls + [curve("spur", [0, 0, 2, 2], 0, 4, 0)], more_vertices=[2, 2])
write("no_face", walls + [curve("spur", [4, 4, 6, 6], 2, 4)], more_vertices=[6, 6])
write("open_loop", walls[:3])
write("gap", walls[:3] + [curve("left wall", [0, 4, 0.001, 0.002], 3, 4, 0)], more_vertices=[0.001, 0.002])
write("beside_its_vertex", walls[:3] + [curve("left wall", [0, 4, 0, 1e-9], 3, 0, 0)])
write("vertex_twice", walls[:2] + [curve("ceiling", [4, 4, 0, 4], 4, 3, 0)] + walls[3:], more_vertices=[4, 4])
write("vertex_twice_unused", walls, more_vertices=[4, 4])
write("vertex_on_a_curve", walls, more_vertices=[2, 0])
# Faces on wrong sides.
write("all_reversed", [side(i, None, 0) for i in range(4)])
write("one_reversed", [walls[0], side(1, None, 0)] + walls[2:])
write("hole_reversed", walls + [disk("hole", 2, 2, 1, 0, None)])
write("cell_reversed", walls + [disk("cell", 2, 2, 1, 0, 1)], inner)
write("cell_in_nothing", walls + [disk("cell", 2, 2, 1, 1, None)], inner)
write("wrong_face", walls + [disk("one", 1, 2, .5, 1, 0), disk("two", 3, 2, .5, 2, 1)], ("room", "one", "two"))
# Spans and knots.
write("span_of_no_length", without_floor + [curve("floor", [0, 0, 2, 0, 2, 0, 4, 0], 0, 1, 0)])
write("point", walls + [curve("dot", [1, 1] * 4, left=0, right=0, degree=2)])
write("stops", without_floor + [curve("floor", [0, 0, 0, 0, 4, 0], 0, 1, 0, degree=2)])
floor = lambda knots, **more: without_floor + [curve("floor", [0, 0, 1, 0, 3, 0, 4, 0], 0, 1, 0, knots=knots, **more)]
text = write("knots_decrease", floor([0, 0, 2, 1, 3, 3]))
for name, value in {"nan": "NaN", "null": "null", "huge": "1e999"}.items():
    open(f"knot_{name}.json", "w").write(text.replace("[0, 0, 2, 1, 3, 3]", f"[0, 0, {value}, 1, 3, 3]"))
write("knots_of_no_length", without_floor + [curve("floor", [0, 0, 4, 0], 0, 1, 0, knots=[1, 1, 1, 1])])
write("knot_too_often", floor([0, 0, 1, 1, 2, 2]))
write("not_clamped", floor([0, 1, 2, 3, 4, 4]))
write("too_few_knots", floor([0, 0, 1, 2, 2]))
# Unusual, but sound.
write("slit", walls + [curve("slit", [1, 1, 2, 2], 4, 5, 0, 0)], more_vertices=[1, 1, 2, 2])
write("slit_at_a_corner", walls + [curve("slit", [0, 0, 2, 2], 0, 4, 0, 0)], more_vertices=[2, 2])
write("vertex_alone", walls, more_vertices=[2, 2])
write("hole_of_two_curves", walls + [curve("a", [1, 1, 2, 1, 2, 2], 4, 5, None, 0),
                                     curve("b", [2, 2, 1, 2, 1, 1], 5, 4, None, 0)], more_vertices=[1, 1, 2, 2])
PYTHON

# refused CASE TEXT...: refused with a message that opens with the file's name and holds each text.
refused() {
  local name=$1 text
  shift
  run 3 timeout 20 bspline2mesh "$name.json"
  no_output
  says "bspline2mesh: $name.json:1: frame 0: "
  for text; do says "$text"; done
}
lines() { (($(wc -l <err) == $1)) || fail "expected $1 lines of message: $(head -c 600 err)"; }

resolve='--resolve cuts curves where they cross, touch or overlap'
refused figure_of_eight "/curves/0: curve 'eight' (0) at parameter 1.5 crosses curve 'eight' (0) at parameter 3.5, at (1, 1): curves may" "$resolve"
lines 2
refused loop_in_a_span "curve 'loop' (3) at parameter 0.0" 'meets itself at parameter 0.9' 'at (2, ' 'a curve may only end where it starts'
refused crossing "/curves/1: curve 'right wall' (1) at parameter 0.2714" " crosses curve 'cell' (4) at parameter" 'at (4, 1.0857' 'at common vertices only' "$resolve"
lines 3
refused through_a_vertex "curve 'right wall' (1) at parameter 1 meets curve 'diamond' (4) at parameter 1, at (4, 4): " \
  "curve 'ceiling' (2) at parameter 0 meets" "$resolve"
lines 3
refused overlap "curve 'right wall' (1) at parameter 0.25 meets curve 'annex' (4) at parameter 1, at (4, 1)" "$resolve"
refused twice "curve 'cell' (4) at parameter 1 meets curve 'again' (5) at parameter 1, at (2, 1)" "$resolve"
refused folded "curve 'there' (0) at parameter 0.5 touches or overlaps curve 'back' (1) at parameter 0.5, at (2, 0)" "$resolve"

refused ends_nowhere "/vertices/8: the boundary of face 'room' ends at vertex 4 (2, 2) and does not close there: " \
  "curve 'spur' (4) ends there, at parameter 1, face 'room' on its left, the outside on its right" \
  'It starts at vertex 0 (0, 0), 2.828427 away'
refused no_face "/curves/4/left: curve 'spur' (4) at parameter 0, (4, 4): the curve has no face on either side; name one"
refused open_loop "/vertices/6: the boundary of face 'room' ends at vertex 3 (0, 4)" "curve 'ceiling' (2) ends there" \
  'It starts at vertex 0 (0, 0), 4 away'
refused gap "curve 'left wall' (3) ends there, at parameter 1" 'starts at vertex 0 (0, 0), 0.002236068 away'
refused beside_its_vertex "/curves/3/end: curve 'left wall' (3) at parameter 1, (0, 1e-09), should end in vertex 0" \
  'that is at (0, 0), 1e-09 away: both need the same coordinates'
refused vertex_twice 'It starts at vertex 4 (4, 4), the same point: one vertex should stand for both'
refused vertex_twice_unused '/vertices/8: vertices 2 and 4 are the same point (4, 4)' 'should name the same vertex'
lines 1
refused vertex_on_a_curve "/vertices/8: vertex 4 (2, 0), no curve's end, lies on curve 'floor' (0) at parameter 0.5: divide"

refused all_reversed "/faces/0: face 'room' lies on the wrong side of all its curves, curve 'floor' (0), " \
  'at parameter 0.5, (2, 0): exchange left and right of all of them'
lines 1
refused one_reversed "curve 'right wall' (1) starts there, at parameter 0, the outside on its left, face 'room' on its right"
beside='at parameter 0.5, (1.25, 1.25), names'
refused hole_reversed "/curves/4/left: curve 'hole' (4) $beside face 'room' on its left, but the outside lies there: exchange left and right"
lines 1
refused cell_reversed "/curves/4/left: curve 'cell' (4) $beside face 'room' on its left, but face 'cell' lies there: exchange left and right"
lines 1
refused cell_in_nothing "/curves/4/right: curve 'cell' (4) $beside the outside on its right, but by all other curves face 'room' lies there"
lines 1
refused wrong_face "curve 'two' (5) at parameter 0.5, (2.625, 1.625), names face 'one' on its right, but by all other curves face 'room'"
lines 1

refused span_of_no_length "curve 'floor' (3) at parameters 1 to 2: the span has no length; it stays at (2, 0): leave it out"
lines 1
refused point "curve 'dot' (4) at parameters 0 to 1: the span has no length; it stays at (1, 1)"
lines 1
refused stops "curve 'floor' (3) at parameter 0: the curve's derivative vanishes at (0, 0): control points coincide there"
refused knots_decrease "/curves/3/knots/3: curve 'floor': knots/3 is 1, but knots/2 is 2: knots do not decrease"
refused knot_nan "/curves/3/knots/2: should be a number, found 'N'"
refused knot_null '/curves/3/knots/2: should be a number, found null'
refused knot_huge '/curves/3/knots/2: is too large for a double'
refused knots_of_no_length "/curves/3/knots/2: curve 'floor': knots/2 is 1, the first knot once too often; an open curve of degree 1 has 2 equal knots at each end"
refused knot_too_often "/curves/3/knots/3: curve 'floor': knots/3 is 1 once too often; a knot inside a curve of degree 1"
refused not_clamped "/curves/3/knots/1: curve 'floor': knots/1 is 1, not the first knot's value; an open curve of degree 1 has 2 equal knots at each end"
refused too_few_knots "/curves/3: curve 'floor': knots: 5 knots, expected 6"

for name in slit slit_at_a_corner vertex_alone hole_of_two_curves; do
  run 0 bspline2mesh "$name.json"
  silent
done
finish
