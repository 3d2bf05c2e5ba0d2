// lib/pliant/geometry/placement/quadratic_shape.h: the least pointwise shape of an element of degree 2 (private).
#pragma once
#include <array>

#include "pliant/geometry/placement/shape_bounds.h"

namespace pliant {

/// A quadratic form of barycentric coordinates by its entries 11, 22, 33, 12, 23, 31: Bernstein coefficients in the
/// order of NetLayout.
using QuadraticForm = std::array<double, 6>;

/// The least of numerator / denominator over the triangle, where the denominator is a sum of squares and the ratio is
/// never below -1; coefficients are known up to `error`. By Dinkelbach's method: the least value F of numerator - t
/// denominator is known in closed form, its place has a lesser ratio as long as F < 0, and the ratio is nowhere less
/// than t + F / (least denominator).
/// Reference   Dinkelbach, On nonlinear fractional programming (1967)
ShapeBounds least_ratio(const QuadraticForm& numerator, const QuadraticForm& denominator, double error);

}  // namespace pliant
