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
/// Rules with positive weights and with points strictly inside, exact (to rounding) for polynomials up to a degree of
/// `exact_degree`, which is 0 to 40. Built once for each degree; thread-safe.
std::span<const TriangleNode> triangle_rule(int exact_degree);
std::span<const SegmentNode> segment_rule(int exact_degree);

}  // namespace pliant
