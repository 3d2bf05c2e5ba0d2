// lib/pliant/geometry/validity/jacobian.h: det J of an element in Bernstein form (paper §5.4).
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"

namespace pliant {

constexpr int jacobian_degree(int degree) { return 2 * (degree - 1); }

/// Coefficients of det J, of degree 2(p - 1), derivatives with respect to (xi2, xi3) on the unit right triangle.
///
/// Shapes      net: net_size(p) points; out: net_size(2(p - 1)), in the order of NetLayout
/// Units       area; a straight-sided element gives twice its signed area, everywhere
/// Paper       §5.4, Figure 8(c); any degree
void jacobian_net(int degree, std::span<const Point> net, std::span<double> out);

/// det J at one point.
double jacobian_at(int degree, std::span<const Point> net, const Barycentric& xi);

/// Signed area of the element: half the mean of the coefficients of det J. Exact up to rounding.
double element_area(int degree, std::span<const Point> net);

}  // namespace pliant
