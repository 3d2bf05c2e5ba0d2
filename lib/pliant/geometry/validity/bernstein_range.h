// lib/pliant/geometry/validity/bernstein_range.h: extrema of a polynomial on the triangle, enclosed.
#pragma once
#include <span>

#include "pliant/geometry/validity/validity.h"

namespace pliant {

/// Guaranteed enclosures [lower, upper] of an extremum, over the closed triangle, of the polynomial with these
/// Bernstein coefficients, each of which is known to within `error`. An enclosure is no wider than the larger of
/// `width` and a few errors (in hopeless cases, after some thousand bisections, it is wider). A quadratic polynomial is
/// divided at the minimum on an edge; others are divided by newest-vertex bisection.
///
/// Shapes      coefficients: net_size(degree), in the order of NetLayout
/// Complexity  O(coefficients) if the extreme coefficients are those at the corners, to within `width`; no allocation
///             for degrees up to 2
Bounds enclose_minimum(int degree, std::span<const double> coefficients, double error, double width);
Bounds enclose_maximum(int degree, std::span<const double> coefficients, double error, double width);

}  // namespace pliant
