#include "pliant/quality/element_quality.h"  // lib/pliant/quality/element_quality.cpp: closed forms and ratios of bounds

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/turning_angle.h"
#include "pliant/geometry/validity.h"
#include "pliant/quality/element_forms.h"

namespace pliant {
namespace {

constexpr std::size_t at(int n) { return static_cast<std::size_t>(n); }
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double distortion(const ElementForms& forms) {
  if (!forms.is_finite) return nan;
  const double mean = forms.mean_jacobian();
  if (!(mean > 0)) return nan;
  // The integral of (c - 1)^2, c = det J / mean, is that of c^2 less 1/2: so the result is 1 exactly where all is
  // equal.
  std::array<double, max_form_size> excess;
  const std::size_t size = at(forms.size());
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
  assert(net.size() >= at(net_size(degree)));
  std::array<double, net_size(max_degree - 1)> basis;
  bernstein_basis(degree - 1, xi, basis);
  const auto triangles = control_triangles(degree);
  Vector along_2, along_3;
  for (std::size_t m = 0; m < at(partials); ++m) {
    const auto [first, second, third] = triangles[m];
    along_2 += basis[m] * (net[at(second)] - net[at(first)]);
    along_3 += basis[m] * (net[at(third)] - net[at(first)]);
  }
  return triangle_shape({0, 0}, along_2, along_3);
}

double scaled_jacobian(int degree, std::span<const Point> net, const ElementForms& forms, double& least_jacobian) {
  least_jacobian = nan;
  if (!forms.is_finite) return nan;
  std::array<Point, net_size(max_degree)> scaled;  // so that det J neither overflows nor underflows
  const double scale = std::ldexp(1.0, -forms.exponent);
  for (std::size_t n = 0; n < at(net_size(degree)); ++n) scaled[n] = scale * net[n];
  const auto [least, greatest] = jacobian_range(degree, std::span(scaled).first(at(net_size(degree))));
  least_jacobian = std::ldexp(least.lower, 2 * forms.exponent);
  const double size = std::max(std::fabs(least.lower), std::fabs(greatest.upper));
  return size > 4 * forms.error ? least.lower / size : 0;
}

double scaled_jacobian(int degree, std::span<const Point> net) {
  ElementForms forms;
  element_forms(degree, net, forms);
  double least_jacobian;
  return scaled_jacobian(degree, net, forms, least_jacobian);
}

double control_shape(int degree, std::span<const Point> net) {
  double least = 1;
  for (const auto& [a, b, c] : control_triangles(degree))
    least = std::min(least, triangle_shape(net[at(a)], net[at(b)], net[at(c)]));
  return least;
}

double element_turning(int degree, std::span<const Point> net) {
  const NetLayout& layout = NetLayout::of(degree);
  std::array<Point, max_degree + 1> polygon;
  double largest = 0;
  for (int e = 0; e < 3; ++e) {
    for (int k = 0; k <= degree; ++k) polygon[at(k)] = net[at(layout.edge_index(e, k))];
    largest = std::max(largest, turning_angle(std::span(polygon).first(at(degree + 1))));
  }
  return largest;
}

double curvature_excess(int degree, std::span<const Point> net, const CurvatureBounds& bounds) {
  ElementForms forms;
  element_forms(degree, net, forms);
  const double bending = distortion(forms);
  const double shape = curved_shape(forms);
  if (!(bending >= 1) || !(shape > 0)) return HUGE_VAL;
  const double logical = triangle_shape(net[0], net[1], net[2]);
  return std::max({bending / bounds.max_distortion, jacobian_peak(forms) / bounds.max_peak,
                   bounds.min_shape_ratio * logical / shape, element_turning(degree, net) / bounds.max_turning});
}

}  // namespace pliant
