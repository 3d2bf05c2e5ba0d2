// lib/pliant/geometry/validity/bernstein_range.h: extrema of a polynomial on the triangle, enclosed.
#pragma once
#include <span>

#include "pliant/geometry/validity/validity.h"

namespace pliant {

/// Guaranteed enclosures of the extrema over the closed triangle of the polynomial with these Bernstein coefficients,
/// each known to within `error`: [lower, upper], no wider than the larger of `width` and a few errors (in hopeless
/// cases, after some thousand bisections, wider). Where a coefficient below all corners stands on an edge, a quadratic
/// is divided at the minimum of that edge, all else by newest-vertex bisection.
///
/// Shapes      coefficients: net_size(degree), in the order of NetLayout
/// Complexity  O(coefficients) where those at the corners are the extreme ones to within `width`; no allocation for
///             degrees up to 2
Bounds enclose_minimum(int degree, std::span<const double> coefficients, double error, double width);
Bounds enclose_maximum(int degree, std::span<const double> coefficients, double error, double width);

}  // namespace pliant
