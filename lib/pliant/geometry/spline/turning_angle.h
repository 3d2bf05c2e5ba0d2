// lib/pliant/geometry/spline/turning_angle.h: by how much a Bézier curve turns.
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// Total absolute turning of the control polygon in radians: an upper bound of the curve's own total turning.
/// Zero legs are skipped; 0 for a straight edge.
double turning_angle(std::span<const Point> polygon);

}  // namespace pliant
