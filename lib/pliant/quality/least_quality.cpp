// lib/pliant/quality/least_quality.cpp: measures an element only if bounds do not show that it is better.
#include "pliant/quality/least_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "pliant/geometry/index.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/quality/element/element_forms.h"

namespace pliant {
namespace {

/// True if the coefficients of the two forms show that the element is better than this in both measures.
bool is_surely_better(const ElementForms& forms, const LeastQuality& than) {
  if (!forms.is_finite || forms.is_point) return false;
  const auto coefficients = std::span<const double>(forms.jacobian).first(index(forms.size()));
  const auto [least, most] = std::minmax_element(coefficients.begin(), coefficients.end());
  if (!(*least > 4 * forms.error && *least > than.scaled_jacobian * *most)) return false;
  const double wanted = than.shape * std::numbers::inv_sqrt3;
  for (std::size_t n = 0; n < coefficients.size(); ++n)
    if (!(coefficients[n] > wanted * forms.squares[n])) return false;
  return true;
}

LeastQuality quality_of(const ElementForms& forms) {
  if (!forms.is_finite) return {-1, -1};
  return {curved_shape(forms), scaled_jacobian(forms, jacobian_range(forms, usual_range_width))};
}

}  // namespace

LeastQuality least_of(const LeastQuality& a, const LeastQuality& b) {
  return {std::min(a.shape, b.shape), std::min(a.scaled_jacobian, b.scaled_jacobian)};
}

LeastQuality element_quality(int degree, std::span<const Point> net) {
  ElementForms forms;
  element_forms(degree, net, forms);
  return quality_of(forms);
}

LeastQuality element_quality(const Mesh& mesh, TriangleId t) {
  std::array<Point, net_size(max_degree)> net;
  mesh.gather_points(t, net);
  return element_quality(mesh.degree(), {net.data(), index(mesh.net_size())});
}

LeastQuality least_quality(const Mesh& mesh, std::span<const TriangleId> elements) {
  LeastQuality least;
  for (const TriangleId t : elements)
    if (mesh.is_alive(t)) least = least_of(least, element_quality(mesh, t));
  return least;
}

LeastQuality least_quality_of_mesh(const Mesh& mesh, std::span<const TriangleId> poor) {
  LeastQuality least = least_quality(mesh, poor);
  std::array<Point, net_size(max_degree)> net;
  ElementForms forms;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    element_forms(mesh.degree(), {net.data(), index(mesh.net_size())}, forms);
    if (!is_surely_better(forms, least)) least = least_of(least, quality_of(forms));
  }
  return least;
}

double least_logical_angle(const Mesh& mesh) {
  constexpr double degrees = 180 / std::numbers::pi;
  double least = 60;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    if (mesh.is_alive(t))
      least = std::min(least, degrees * least_angle(mesh.point(mesh.corner(t, 0)), mesh.point(mesh.corner(t, 1)),
                                                    mesh.point(mesh.corner(t, 2))));
  return least;
}

}  // namespace pliant
