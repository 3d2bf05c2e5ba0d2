// lib/pliant/geometry/validity/jacobian.h: det J of an element in Bernstein form (paper §5.4).
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"

namespace pliant {

/// The degree of det J of an element of this degree.
constexpr int jacobian_degree(int degree) { return 2 * (degree - 1); }

/// Bernstein coefficients of det J; derivatives are with respect to (xi2, xi3) on the unit right triangle.
///
/// Shapes      net: net_size(p) points; out: net_size(2(p - 1)), in the order of NetLayout
/// Units       area; all coefficients of a straight-sided element are twice its signed area
/// Paper       §5.4, Figure 8(c); any degree
void jacobian_net(int degree, std::span<const Point> net, std::span<double> out);

/// det J at one point.
double jacobian_at(int degree, std::span<const Point> net, const Barycentric& xi);

/// Signed area of the element, exact up to rounding: half the mean of the coefficients of det J.
double element_area(int degree, std::span<const Point> net);

}  // namespace pliant
