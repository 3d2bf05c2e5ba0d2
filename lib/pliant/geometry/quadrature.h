// lib/pliant/geometry/quadrature.h: points and weights on the unit right triangle and on [0, 1].
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

struct TriangleNode {
  Barycentric xi;
  double weight;  ///< the weights sum to 1/2, the area of the unit right triangle
};
struct SegmentNode {
  double s, weight;  ///< the weights sum to 1
};
/// Rules with positive weights and inner points, exact for polynomials of degree <= `exact_degree` (to rounding).
/// Built once for each degree (0..40); thread-safe.
std::span<const TriangleNode> triangle_rule(int exact_degree);
std::span<const SegmentNode> segment_rule(int exact_degree);

}  // namespace pliant
