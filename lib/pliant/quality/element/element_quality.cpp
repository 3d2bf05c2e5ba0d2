// lib/pliant/quality/element/element_quality.cpp: measures by closed formulas, and by ratios of guaranteed bounds.
#include "pliant/quality/element/element_quality.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/spline/turning_angle.h"
#include "pliant/geometry/validity/bernstein_range.h"
#include "pliant/quality/element/element_forms.h"
#include "pliant/quality/nan.h"

namespace pliant {
namespace {

double any_turning(int degree, std::span<const Point> net) {
  const NetLayout& layout = NetLayout::of(degree);
  std::array<Point, max_degree + 1> polygon;
  double largest = 0;
  for (int e = 0; e < 3; ++e) {
    for (int k = 0; k <= degree; ++k) polygon[index(k)] = net[index(layout.edge_index(e, k))];
    largest = std::max(largest, turning_angle(std::span(polygon).first(index(degree + 1))));
  }
  return largest;
}

/// For p = 2, one arc tangent serves all three edges: (dot, |cross|) of the two legs of an edge is a vector in the
/// upper half-plane, and the leftmost of the three vectors belongs to the largest angle.
double quadratic_turning(std::span<const Point> net) {
  Vector largest{1, 0};
  for (std::size_t e = 0; e < 3; ++e) {
    const Vector a = net[3 + e] - net[e], b = net[(e + 1) % 3] - net[3 + e];
    Vector turn{dot(a, b), std::fabs(cross(a, b))};
    const double size = std::fabs(turn.x) + turn.y;
    if (!(size > 0 && std::isfinite(size))) return any_turning(2, net);  // the length of a leg is 0 or extreme
    turn *= 1 / size;
    if (cross(largest, turn) > 0 || (turn.y == 0 && turn.x < 0)) largest = turn;
  }
  return turn_of(largest.y, largest.x);
}

}  // namespace

double distortion(const ElementForms& forms) {
  if (!forms.is_finite) return nan;
  const double mean = forms.mean_jacobian();
  if (!(mean > 0)) return nan;
  // With c = det J / mean, the integral of c^2 is that of (c - 1)^2 plus 1/2. Computed so, the result is exactly 1 if
  // all coefficients are equal.
  std::array<double, max_form_size> excess;
  const std::size_t size = index(forms.size());
  for (std::size_t n = 0; n < size; ++n) excess[n] = forms.jacobian[n] / mean - 1;
  const std::span<const double> mass = mass_matrix(forms.degree);
  double sum = 0;
  for (std::size_t m = 0; m < size; ++m) {
    double row = 0;
    for (std::size_t n = 0; n < size; ++n) row += mass[m * size + n] * excess[n];
    sum += row * excess[m];
  }
  return 1 + 2 * std::max(sum, 0.0);
}

double distortion(int degree, std::span<const Point> net) {
  ElementForms forms;
  element_forms(degree, net, forms);
  return distortion(forms);
}

double jacobian_peak(const ElementForms& forms) {
  if (!forms.is_finite) return nan;
  const double mean = forms.mean_jacobian();
  return mean > 0 ? *std::max_element(forms.jacobian.begin(), forms.jacobian.begin() + forms.size()) / mean : nan;
}

double jacobian_peak(int degree, std::span<const Point> net) {
  ElementForms forms;
  element_forms(degree, net, forms);
  return jacobian_peak(forms);
}

double shape_at(int degree, std::span<const Point> net, const Barycentric& xi) {
  const int partials = net_size(degree - 1);
  assert(net.size() >= index(net_size(degree)));
  std::array<double, net_size(max_degree - 1)> basis;
  bernstein_basis(degree - 1, xi, basis);
  const auto triangles = control_triangles(degree);
  Vector along_2, along_3;
  for (std::size_t m = 0; m < index(partials); ++m) {
    const auto [first, second, third] = triangles[m];
    along_2 += basis[m] * (net[index(second)] - net[index(first)]);
    along_3 += basis[m] * (net[index(third)] - net[index(first)]);
  }
  return triangle_shape({0, 0}, along_2, along_3);
}

FormRange jacobian_range(const ElementForms& forms, double relative_width) {
  if (!forms.is_finite) return {{nan, nan}, {nan, nan}};
  const auto coefficients = std::span<const double>(forms.jacobian).first(index(forms.size()));
  double greatest = 0;
  for (const double c : coefficients) greatest = std::max(greatest, std::fabs(c));
  const double width = relative_width * greatest;
  return {enclose_minimum(forms.degree, coefficients, forms.error, width),
          enclose_maximum(forms.degree, coefficients, forms.error, width)};
}

double scaled_jacobian(const ElementForms& forms, const FormRange& range) {
  if (!forms.is_finite) return nan;
  const double size = std::max(std::fabs(range.least.lower), std::fabs(range.greatest.upper));
  return size > 4 * forms.error ? range.least.lower / size : 0;
}

double scaled_jacobian(int degree, std::span<const Point> net) {
  ElementForms forms;
  element_forms(degree, net, forms);
  return scaled_jacobian(forms, jacobian_range(forms, 1e-3));
}

double control_shape(int degree, std::span<const Point> net) {
  double least = 1;
  for (const auto& [a, b, c] : control_triangles(degree))
    least = std::min(least, triangle_shape(net[index(a)], net[index(b)], net[index(c)]));
  return least;
}

double element_turning(int degree, std::span<const Point> net) {
  return degree == 2 ? quadratic_turning(net) : any_turning(degree, net);
}

}  // namespace pliant
