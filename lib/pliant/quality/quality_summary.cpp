// lib/pliant/quality/quality_summary.cpp: extremes over the elements, and sizes of the field components by quadrature.
#include "pliant/quality/quality_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/quadrature.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/quality/element/element_measures.h"
#include "pliant/quality/nan.h"
#include "pliant/quality/quality_report.h"

namespace pliant {
namespace {

/// Index of the first value at a control point, as seen from a face; none if a field by face has no value there.
std::ptrdiff_t first_value(const Field& field, PointId p, FaceId f) {
  std::ptrdiff_t row = p;
  if (field.by_face) {
    const std::array<std::int32_t, 2> place{p, f};
    const auto found = std::lower_bound(field.places.begin(), field.places.end(), place);
    if (found == field.places.end() || *found != place) return none;
    row = found - field.places.begin();
  }
  return row * field.components;
}

/// The basis functions of field and det J at each node of a quadrature rule that is exact for u² det J.
struct Tables {
  std::span<const TriangleNode> rule;
  std::vector<double> of_field, of_jacobian;

  explicit Tables(int degree) : rule(triangle_rule(2 * degree + jacobian_degree(degree))) {
    const auto fill = [this](int of_degree, std::vector<double>& table) {
      const std::size_t n = index(net_size(of_degree));
      table.resize(n * rule.size());
      for (std::size_t q = 0; q < rule.size(); ++q)
        bernstein_basis(of_degree, rule[q].xi, std::span<double>(table).subspan(q * n, n));
    };
    fill(degree, of_field);
    fill(jacobian_degree(degree), of_jacobian);
  }
};

/// Measures how large each component of each field is.
std::vector<ComponentSize> measure_fields(const MeshData& data) {
  std::vector<ComponentSize> sizes;
  for (const Field& field : data.fields)
    for (int c = 0; c < field.components; ++c) sizes.push_back({field.name, c, nan, 0});
  if (sizes.empty()) return sizes;
  const Tables tables(data.degree);
  const std::size_t n = index(net_size(data.degree)), m = index(net_size(jacobian_degree(data.degree)));
  std::vector<Point> net(n);
  std::vector<double> jacobian(m), areas(tables.rule.size()), values(n);
  for (std::size_t t = 0; t < data.triangle_faces.size(); ++t) {
    const PointId* const ids = &data.triangles[t * n];
    for (std::size_t k = 0; k < n; ++k) net[k] = data.points[index(ids[k])];
    jacobian_net(data.degree, net, jacobian);
    for (std::size_t q = 0; q < areas.size(); ++q)
      areas[q] =
          tables.rule[q].weight * std::inner_product(jacobian.begin(), jacobian.end(), &tables.of_jacobian[q * m], 0.0);
    auto size = sizes.begin();
    for (const Field& field : data.fields)
      for (int c = 0; c < field.components; ++c, ++size) {
        for (std::size_t k = 0; k < n; ++k) {
          const std::ptrdiff_t first = first_value(field, ids[k], data.triangle_faces[t]);
          values[k] = first < 0 ? nan : field.values[index(first + c)];
          size->largest = std::fmax(size->largest, std::fabs(values[k]));
        }
        for (std::size_t q = 0; q < areas.size(); ++q) {
          const double u = std::inner_product(values.begin(), values.end(), &tables.of_field[q * n], 0.0);
          size->l2 += areas[q] * u * u;
        }
      }
  }
  for (ComponentSize& size : sizes) size.l2 = std::sqrt(size.l2);
  return sizes;
}

}  // namespace

QualitySummary summarize_quality(const MeshData& data) {
  QualitySummary summary{std::ssize(data.triangle_faces), 0, 0, nan, nan, nan, nan, {}};
  std::vector<TriangleId> all(data.triangle_faces.size());
  std::iota(all.begin(), all.end(), 0);
  // fmin and fmax leave NaN out; report_quality leaves out all that is not finite.
  const auto value = [](double x) { return std::isfinite(x) ? x : nan; };
  measure_elements(data, all, QualityOptions().jacobian_width,
                   [&](std::size_t, std::span<const ElementMeasures> measures) {
                     for (const ElementMeasures& m : measures) {
                       summary.invalid += m.validity == Validity::invalid;
                       summary.degenerate += m.validity == Validity::degenerate;
                       summary.min_logical_angle = std::fmin(summary.min_logical_angle, value(m.logical_angle));
                       summary.min_scaled_jacobian = std::fmin(summary.min_scaled_jacobian, value(m.scaled_jacobian));
                       summary.min_shape = std::fmin(summary.min_shape, value(m.shape));
                       summary.max_distortion = std::fmax(summary.max_distortion, value(m.distortion));
                     }
                   });
  summary.fields = measure_fields(data);
  return summary;
}

std::vector<ComponentGrowth> field_growth(const QualitySummary& before, const QualitySummary& after) {
  const auto ratio = [](double to, double from) { return to == 0 && from == 0 ? 1 : to / from; };
  std::vector<ComponentGrowth> growth;
  for (const ComponentSize& now : after.fields)
    for (const ComponentSize& then : before.fields)
      if (now.field == then.field && now.component == then.component)
        growth.push_back({now.field, now.component, ratio(now.largest, then.largest), ratio(now.l2, then.l2)});
  return growth;
}

}  // namespace pliant
