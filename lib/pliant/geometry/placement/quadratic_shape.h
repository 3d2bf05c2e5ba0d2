// lib/pliant/geometry/placement/quadratic_shape.h: the least pointwise shape of an element of degree 2 (private).
#pragma once
#include <array>

#include "pliant/geometry/placement/shape_bounds.h"

namespace pliant {

/// A quadratic form of barycentric coordinates, given by its entries 11, 22, 33, 12, 23, 31. These are its Bernstein
/// coefficients in the order of NetLayout.
using QuadraticForm = std::array<double, 6>;

/// The least of numerator / denominator over the triangle, by Dinkelbach's method: the least value F of numerator - t
/// denominator is known in closed form. As long as F < 0, the ratio at its place is less than t; nowhere is the ratio
/// less than t + F / (least denominator).
///
/// Requires    the denominator is a sum of squares; the ratio is nowhere below -1; `error` bounds the error of each
///             coefficient
/// Reference   Dinkelbach, On nonlinear fractional programming (1967)
ShapeBounds least_ratio(const QuadraticForm& numerator, const QuadraticForm& denominator, double error);

}  // namespace pliant
