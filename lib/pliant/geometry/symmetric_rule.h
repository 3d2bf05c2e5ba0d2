// lib/pliant/geometry/symmetric_rule.h: quadrature rules on the triangle with few points.
#pragma once
#include <span>

#include "pliant/geometry/quadrature.h"

namespace pliant {

/// A rule like those of `triangle_rule`, with fewer points: for finite elements, which evaluate much at each of them.
/// Positive weights, points strictly inside, exact up to a degree of `exact_degree`, which is 0 to 40. Above 20 it is
/// triangle_rule's. Built once for each degree; thread-safe.
///
/// Source      degrees 6 to 20: Witherden and Vincent, "On the identification of symmetric quadrature rules for finite
///             element methods", Computers & Mathematics with Applications 69 (2015); 12, 16, 25, 33, 42, 60, 67 and 79
///             points for degrees 6, 8, 10, 12, 14, 17, 18 and 20, improved to 20 digits by Newton's method
std::span<const TriangleNode> symmetric_rule(int exact_degree);

}  // namespace pliant
