// formats/svg_import/svg_reader.h: the filled shapes of an SVG drawing as a boundary complex (formats/svg_import.md).
#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/boundary/fault.h"

namespace pliant {

/// The longest drawing that is read.
inline constexpr std::size_t most_svg_bytes = std::numeric_limits<int>::max();

/// What coordinates of the result count: user units of the drawing's root, or lengths on its page.
enum class LengthUnit { user, px, mm, cm, in };

/// How strokes are read: not at all; as the curves that they follow, which cut faces; as faces of the area that they
/// paint.
enum class Strokes { left_out, curves, area };

struct SvgReadOptions {
  int degree = 2;           ///< highest degree of the curves, 2 or 3; cubics are exact at 3
  double tolerance = 1e-6;  ///< how far fitted cubics and arcs may be off, as a part of the drawing's size; with
                            ///< `planar` curves closer than this run together
  bool planar = false;      ///< shapes may meet: each gives way to those painted after it (arrange)
  Strokes strokes = Strokes::left_out;  ///< any but left_out makes the drawing planar
  LengthUnit unit = LengthUnit::user;   ///< of the result's coordinates
};

struct SvgImport {
  BoundaryComplex boundary;
  std::vector<std::string> warnings;  ///< a sentence for each kind of thing that is not read
  long shapes = 0;                    ///< filled shapes
  long unfilled = 0, hidden = 0;      ///< shapes left out: without a fill, not displayed or not visible
  long lines = 0;                     ///< curves of strokes
  long bare_lines = 0;                ///< pieces of them left out: no face is beside them
  long no_area = 0;                   ///< loops left out: they have no interior
  long no_border = 0;                 ///< loops left out: the same shape on both sides
  long pieces = 0, fitted = 0;        ///< Bézier pieces, and those of them that are not exact
  long smooth = 0, corners = 0;       ///< joins of pieces: simple knots or corners
  std::vector<std::string> costs;     ///< a sentence where fitting multiplies the curves: what would take fewer pieces
  long intersections = 0;             ///< of a planar drawing: places where curves meet
  double snapped = 0;                 ///< length: curves closer than this run together
  long slivers = 0;                   ///< pieces of curves that were merged with one beside them
  double sliver_area = 0;             ///< upper bound of the area between them
  long covered = 0;                   ///< shapes of which nothing is left
  double size = 0;                    ///< diagonal of the box of all control points
  double error = 0;                   ///< upper bound of the distance from the drawing (length)
};

/// Reads a drawing: every filled shape becomes a face, and its loops become curves. y points upwards: y of the result
/// is -y of the drawing, in user units.
/// Lines and quadratic curves are kept exactly, cubics at degree 3; what is fitted keeps the tangents at its ends.
/// Smooth joins become knots of multiplicity degree - 1, the others of multiplicity degree or vertices.
///
/// With `planar` a face is what is seen of its shape, and the faces are disjoint whatever the shapes are.
///
/// Ensures     check_boundary and check_boundary_geometry are empty
/// Throws      InputError, with "line L, column C" in place of a pointer where it is an element's fault: no SVG, bad
///             values, nothing filled, shapes that cross, touch or lie over each other (with `planar`: shapes that
///             cannot be arranged)
/// Complexity  O(n log n + pairs of boxes of curves that overlap) in the bytes and the pieces
SvgImport read_svg(std::string_view bytes, const SvgReadOptions& options = {});

}  // namespace pliant
