// lib/pliant/geometry/placement/shape_bounds.h: the least pointwise shape of a curved element, enclosed.
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// lower <= min tau(xi) <= upper, and a place where tau is `upper`.
struct ShapeBounds {
  double lower, upper;
  Barycentric worst;
};

/// Encloses the least of tau(xi) = 2 det T / |T|^2 over the closed element, T the Jacobian of the map from the
/// equilateral triangle: upper - lower <= max(relative_width * |upper|, 1e-11), unless the element is so nearly
/// degenerate that `most_pieces` bisections, or doubles, do not get there. Both det T and |T|^2 are polynomials in
/// Bernstein form, and the least ratio of their coefficients bounds the ratio; the piece with the least bound is
/// bisected next. At p = 2 they are quadratic forms, and the enclosure of a piece is as narrow as rounding allows:
/// nearly always of the element itself.
///
/// Shapes      net: net_size(degree) points in the order of NetLayout; the size of the element does not matter
ShapeBounds least_shape(int degree, std::span<const Point> net, double relative_width = 1e-2, int most_pieces = 400);

}  // namespace pliant
