// formats/svg_import/areas/stroke.h: the area that a stroke paints, as outlines.
#pragma once
#include <vector>

#include "formats/svg_import/areas/outline.h"

namespace pliant::svg {

enum class LineJoin { miter, round, bevel };
enum class LineCap { butt, round, square };

/// How an outline is stroked, in its own coordinates.
struct StrokeStyle {
  double width = 1;
  LineJoin join = LineJoin::miter;
  LineCap cap = LineCap::butt;
  double miter_limit = 4;
  std::vector<double> dashes{};  ///< lengths of dashes and gaps by turns, an even number of them; none: no gaps
  double dash_offset = 0;
};

inline constexpr long most_dashes = 100'000;     ///< of one outline
inline constexpr long most_offsets = 1'000'000;  ///< curves beside one outline

/// Loops whose union is the painted area: points with a winding number other than 0. Each loop winds around what it
/// bounds in the same direction, so that none takes away what another one paints. Offset curves are cubics that are
/// nowhere farther than the tolerance from the true ones (found by samples); caps and round joins are arcs.
///
/// Throws      InputError for more dashes or curves than the limits
/// Complexity  O(steps of the outline + dashes + curves beside it, which grow as tolerance^(-1/4))
Outline stroke_area(const Outline& path, const StrokeStyle& style, double tolerance);

}  // namespace pliant::svg
