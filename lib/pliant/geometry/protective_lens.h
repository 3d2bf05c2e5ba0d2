#pragma once  // lib/pliant/geometry/protective_lens.h: does a point encroach on a curved boundary edge? (paper §5.3.2)
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// True if p lies inside the protective lens of a Bézier curve: the region from which the chord is seen under an angle
/// larger than 90 degrees (the diametral circle) extended on the side of the curve so that it contains the curved
/// segment: the union of the diametral circle and the arcs through both ends and tangent to the hull of the control
/// polygon. Reduces to the diametral circle for a straight edge. The ends themselves do not encroach.
///
/// Shapes      polygon: degree + 1 points
/// Paper       §5.3.2, after [17]
bool is_encroached(std::span<const Point> polygon, const Point& p);

}  // namespace pliant
