// lib/pliant/geometry/spline/protective_lens.h: does a point encroach on a curved boundary edge? (paper §5.3.2).
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// True if p lies inside the protective lens of a Bézier curve. The lens is the diametral circle of the chord, from
/// inside which the chord is seen under more than 90 degrees. On each side on which the control polygon of the curve's
/// two halves leaves the circle, the lens is extended to the arc through both ends that just contains this polygon, but
/// no farther than the arc from which the chord is seen under 30 degrees. Up to that limit the lens contains the curve.
/// The ends themselves, and the boundary of the lens, do not encroach.
///
/// Shapes      polygon: degree + 1 points
/// Paper       §5.3.2, after [17]
bool is_encroached(std::span<const Point> polygon, const Point& p);

}  // namespace pliant
