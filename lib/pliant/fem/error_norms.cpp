// lib/pliant/fem/error_norms.cpp: integrates squares of differences, element after element.
#include "pliant/fem/error_norms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "pliant/boundary/fault.h"
#include "pliant/fem/element_map.h"
#include "pliant/fem/element_values.h"
#include "pliant/geometry/index.h"
#include "pliant/mesh/interpolate_nodes.h"

namespace pliant {
namespace {

double evaluate(const Coefficient& function, const CoefficientPoint& at) {
  const double value = function(at);
  if (std::isfinite(value)) return value;
  std::ostringstream text;
  text << function.name() << " is not finite at (" << at.place.x << ", " << at.place.y << ") and time " << at.time;
  throw InputError("", text.str());
}

/// The derivative along `step`, by central differences of order 6, times the length of the step.
double difference(const Coefficient& function, const CoefficientPoint& at, const Vector& step) {
  constexpr std::array weights{45.0, -9.0, 1.0};
  double sum = 0;
  for (int k = 1; k <= 3; ++k) {
    CoefficientPoint ahead = at, behind = at;
    ahead.place += k * step;
    behind.place -= k * step;
    sum += weights[index(k - 1)] * (evaluate(function, ahead) - evaluate(function, behind));
  }
  return sum / 60;
}

}  // namespace

ErrorNorms error_norms(const Mesh& mesh, const std::string& field, std::span<const std::optional<Coefficient>> exact,
                       int component) {
  constexpr double step_part = 1e-3;  // of an element's size
  const std::vector<double> values = element_values(mesh, find_field(mesh, field), component);
  const int p = mesh.degree();
  const double unit = mesh.boundary().unit;
  ErrorNorms norms;
  norms.exact_degree = std::min(4 * p + 6, 40);
  const ElementTable& table = element_table(p, norms.exact_degree);
  ElementMap map(p);
  const std::size_t n = index(mesh.net_size());
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    const std::optional<Coefficient>& function = exact[index(mesh.face(t))];
    if (!function) continue;
    map.set(mesh, mesh.points(), t, table);
    for (int q = 0; q < table.points; ++q) {
      double value = 0, along_2 = 0, along_3 = 0;
      for (std::size_t k = 0; k < n; ++k) {
        const double c = values[index(t) * n + k];
        value += c * table.values_at(q)[k];
        along_2 += c * table.along_2_at(q)[k];
        along_3 += c * table.along_3_at(q)[k];
      }
      const Vector to_2 = map.along_2(q), to_3 = map.along_3(q);
      const double det = map.det(q), step = step_part * std::sqrt(det);
      const Vector gradient{(along_2 * to_3.y - along_3 * to_2.y) / det, (along_3 * to_2.x - along_2 * to_3.x) / det};
      const CoefficientPoint at{mesh, t, table.xi[index(q)], unit * map.place(q), mesh.time};
      const double off = value - evaluate(*function, at);
      const Vector wanted{difference(*function, at, {unit * step, 0}) / step,
                          difference(*function, at, {0, unit * step}) / step};
      norms.l2 += map.measure(q) * off * off;
      norms.h1 += map.measure(q) * squared_length(gradient - wanted);
    }
  }
  return {unit * std::sqrt(norms.l2), std::sqrt(norms.h1), norms.exact_degree};
}

}  // namespace pliant
