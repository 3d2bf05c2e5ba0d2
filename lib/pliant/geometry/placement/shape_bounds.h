// lib/pliant/geometry/placement/shape_bounds.h: the least pointwise shape of a curved element, enclosed.
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// lower <= min tau(xi) <= upper.
struct ShapeBounds {
  double lower, upper;
  Barycentric worst;  ///< a point where tau is `upper`
};

/// Encloses the least of tau(xi) = 2 det T / |T|^2 over the closed element, where T is the Jacobian of the map from the
/// equilateral triangle. upper - lower <= max(relative_width * |upper|, 1e-11), unless the element is so nearly
/// degenerate that `most_pieces` bisections, or doubles, do not reach that. Both det T and |T|^2 are polynomials in
/// Bernstein form, and the least ratio of their coefficients is a bound of their ratio; the piece with the least bound
/// is bisected next. At p = 2 they are quadratic forms, which are enclosed as narrowly as rounding allows, so that
/// nearly always nothing is bisected.
///
/// Shapes      net: net_size(degree) points in the order of NetLayout; the size of the element does not matter
ShapeBounds least_shape(int degree, std::span<const Point> net, double relative_width = 1e-2, int most_pieces = 400);

}  // namespace pliant
