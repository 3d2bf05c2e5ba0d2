// lib/pliant/geometry/control_net.h: de Casteljau on rows of control values (position, then fields).
#pragma once
#include <span>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"

// A *net* here is net_size(degree) rows of `width` doubles, row-major, rows in the order of NetLayout; a *polygon* is
// degree + 1 rows. A row is one control value: x, y, then every carried field. Width 1 is a scalar polynomial.
// For degree <= max_degree and width <= 16 no function here allocates, apart from tables built once for each degree.
namespace pliant {

/// The value (width doubles) of the net's polynomial at `xi`, by de Casteljau.   Complexity O(width * degree^3)
void evaluate_net(int degree, int width, std::span<const double> net, const Barycentric& xi, std::span<double> value);

/// The same, with the partial derivatives with respect to xi2 and xi3, where xi1 = 1 - xi2 - xi3.
void evaluate_net(int degree, int width, std::span<const double> net, const Barycentric& xi, std::span<double> value,
                  std::span<double> along_2, std::span<double> along_3);

/// The net of the same polynomial on the triangle with corners a, b, c (in barycentric coordinates of the net's own
/// triangle), by blossoming. A corner that is exactly a corner of the net's own triangle is kept: its row is copied bit
/// for bit, without arithmetic.
void sub_net(int degree, int width, std::span<const double> net, const Barycentric& a, const Barycentric& b,
             const Barycentric& c, std::span<double> out);

/// Splits a Bézier polygon at s in (0, 1): `left` is on [0, s], `right` on [s, 1].
void split_polygon(int degree, int width, std::span<const double> polygon, double s, std::span<double> left,
                   std::span<double> right);

/// The value of a Bézier polygon at s.
void evaluate_polygon(int degree, int width, std::span<const double> polygon, double s, std::span<double> value);

/// Degree elevation by one: `out` receives the rows of the same polynomial, written with degree + 1.
void elevate_net(int degree, int width, std::span<const double> net, std::span<double> out);
void elevate_polygon(int degree, int width, std::span<const double> polygon, std::span<double> out);

/// Turns values at equally spaced nodes into control values, in place. The ends of a polygon stay bit for bit. In a net
/// only the interior rows change: on entry they hold values at the lattice nodes, on return control values. The rows of
/// corners and edges must be control values already.
void interpolate_polygon(int degree, int width, std::span<double> polygon);
void interpolate_interior(int degree, int width, std::span<double> net);

}  // namespace pliant
