// lib/pliant/quality/element/element_forms.h: det J and the squared norm of the Jacobian, scaled (private here).
#pragma once
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"
#include "pliant/geometry/validity/validity.h"

namespace pliant {

inline constexpr int max_form_size = net_size(2 * (max_degree - 1));

/// Bernstein coefficients, of degree 2(p - 1) and in the order of NetLayout, of the two forms that tau is the ratio of,
/// for the element divided by a power of two. With a and b the derivatives along (xi2, xi3):
/// det J = a x b, and squares = |a|^2 - a.b + |b|^2, half the sum of the squared sides of the triangle a, b, b - a.
/// tau = sqrt(3) det J / squares. The power of two keeps products of elements of any size from over- and underflowing.
struct ElementForms {
  int degree = 0;         ///< of the forms
  double unit = 1;        ///< lengths are divided by this power of two
  bool is_point = false;  ///< all control points coincide
  bool is_finite = true;  ///< false: differences of control points overflow, and nothing else here is set
  double error = 0;       ///< floating-point error bound of each coefficient of either form
  std::array<double, max_form_size> jacobian, squares;

  int size() const { return net_size(degree); }
  /// Mean of the coefficients of det J: twice the signed area.
  double mean_jacobian() const;
  /// det J, or an area, of the element itself; infinite where that overflows.
  double unscaled(double area) const { return area * unit * unit; }
};
void element_forms(int degree, std::span<const Point> net, ElementForms& forms);

/// The measures of element_quality.h, from the forms; NaN where these are not finite.
double distortion(const ElementForms& forms);
double curved_shape(const ElementForms& forms);
double jacobian_peak(const ElementForms& forms);

/// Of curved_shape: from its bound to the true minimum.
inline constexpr double shape_relative_width = 0.01, shape_absolute_width = 1e-6;
/// ElementForms::error for p = 2.
inline constexpr double quadratic_error = (2 + 10) * 0x1p-53 * 16 * 4;

/// Guaranteed enclosures of the extrema of det J, scaled as the forms are, to `relative_width` of the largest
/// coefficient. NaN where the forms are not finite.
struct FormRange {
  Bounds least, greatest;
};
FormRange jacobian_range(const ElementForms& forms, double relative_width);
double scaled_jacobian(const ElementForms& forms, const FormRange& range);

/// The angle in [0, pi] with this sine and cosine, up to a common factor; for small ones, most edges', the quotient.
inline double turn_of(double sine, double cosine) {
  return sine < 0x1p-28 * cosine ? sine / cosine : std::atan2(sine, cosine);
}

/// For each degree p, once: the triangles of the control net, as indices into it, counter-clockwise: first those that
/// stand as the element does (its partial derivatives are their sides), in the order of NetLayout(p - 1), then those
/// turned over. p^2 in all.
std::span<const std::array<int, 3>> control_triangles(int degree);

}  // namespace pliant
