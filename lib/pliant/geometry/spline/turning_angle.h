// lib/pliant/geometry/spline/turning_angle.h: by how much a Bézier curve turns.
#pragma once
#include <cmath>
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// Total absolute turning of the control polygon in radians: an upper bound of the curve's own total turning.
/// Zero legs are skipped; 0 for a straight edge.
double turning_angle(std::span<const Point> polygon);

/// True if the cosine of the angle between two vectors is at least `least`, with a margin for rounding; false if
/// squares over- or underflow.
inline bool is_turn_within(const Vector& from, const Vector& to, double least) {
  constexpr double margin = 1e-9;
  const double product = dot(from, to), squares = squared_length(from) * squared_length(to);
  if (!(squares > 0) || !std::isfinite(squares)) return false;
  const double signed_square = product * std::fabs(product);
  return signed_square >= (least * std::fabs(least) + margin) * squares;
}

}  // namespace pliant
