// lib/pliant/geometry/spline/protective_lens.h: does a point encroach on a curved boundary edge? (paper §5.3.2).
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// True if p lies inside the protective lens of a Bézier curve: the diametral circle of its chord (the chord is seen
/// under more than 90 degrees), extended on the side of the curve to the arc through both ends that just contains the
/// curve's control polygon, subdivided once (the chord is seen under an angle as large as from there; at least 30
/// degrees). So the lens contains the curve. Reduces to the diametral circle for a straight edge, and for an arc of
/// less than a half circle. The ends themselves, and the boundary of the lens, do not encroach.
///
/// Shapes      polygon: degree + 1 points
/// Paper       §5.3.2, after [17]
bool is_encroached(std::span<const Point> polygon, const Point& p);

}  // namespace pliant
