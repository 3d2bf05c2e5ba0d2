// lib/pliant/geometry/spline/turning_angle.cpp: the sum of the angles between successive legs of the polygon.
#include "pliant/geometry/spline/turning_angle.h"

namespace pliant {

double turning_angle(std::span<const Point> polygon) {
  double sum = 0;
  Vector last;
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    const Vector leg = polygon[i] - polygon[i - 1];
    if (leg == Vector{}) continue;
    if (last != Vector{}) sum += std::fabs(std::atan2(cross(last, leg), dot(last, leg)));
    last = leg;
  }
  return sum;
}

}  // namespace pliant
