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

/// The two polynomials whose ratio is tau: their Bernstein coefficients, of degree 2 (p - 1) and in the order of
/// NetLayout, for the element divided by a power of two. That power keeps products from over- and underflowing for
/// elements of any size. With a and b the derivatives along xi2 and xi3:
///   det J = a x b
///   squares = |a|^2 - a.b + |b|^2, half the sum of the squared sides of the triangle a, b, b - a
///   tau = sqrt(3) det J / squares
struct ElementForms {
  int degree = 0;         ///< degree of the two polynomials, 2 (p - 1)
  double unit = 1;        ///< lengths are divided by this power of two
  bool is_point = false;  ///< all control points coincide
  bool is_finite = true;  ///< false: differences of control points overflow, and nothing else here is set
  double error = 0;       ///< bound of the rounding error of each coefficient of either polynomial
  std::array<double, max_form_size> jacobian, squares;

  int size() const { return net_size(degree); }
  /// The mean of the coefficients of det J: twice the signed area of the scaled element.
  double mean_jacobian() const;
  /// A value of det J, or an area, in the units of the element itself; infinite if it overflows.
  double unscaled(double area) const { return area * unit * unit; }
};
void element_forms(int degree, std::span<const Point> net, ElementForms& forms);

/// The measures of element_quality.h, from the forms; NaN if these are not finite.
double distortion(const ElementForms& forms);
double curved_shape(const ElementForms& forms);
double jacobian_peak(const ElementForms& forms);

/// curved_shape is below the true minimum by at most the larger of these, the first times the minimum.
inline constexpr double shape_relative_width = 0.01, shape_absolute_width = 1e-6;
/// ElementForms::error for p = 2 (there most_terms is 2).
inline constexpr double quadratic_error = (2 + 10) * 0x1p-53 * 16 * 4;

/// Guaranteed enclosures of the least and of the greatest det J, in the scale of the forms. Each is at most
/// `relative_width` times the largest coefficient wide. NaN if the forms are not finite.
struct FormRange {
  Bounds least, greatest;
};
FormRange jacobian_range(const ElementForms& forms, double relative_width);
/// The width where none is asked for: the default of QualityOptions::jacobian_width.
inline constexpr double usual_range_width = 1e-3;
double scaled_jacobian(const ElementForms& forms, const FormRange& range);

/// The angle in [0, pi] whose sine and cosine are these, up to a common factor. Most edges turn so little that the
/// quotient is the angle.
inline double turn_of(double sine, double cosine) {
  return sine < 0x1p-28 * cosine ? sine / cosine : std::atan2(sine, cosine);
}

/// The p^2 triangles of a control net, as indices into it, counter-clockwise. First come those that stand as the
/// element does, in the order of NetLayout(p - 1): their sides are the partial derivatives over p. Then come those
/// upside down.
std::span<const std::array<int, 3>> control_triangles(int degree);

}  // namespace pliant
