// lib/pliant/quality/field_figures.cpp: integrals as sums of a control value times the integral of its basis function.
#include "pliant/quality/field_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>

#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/quality/nan.h"

namespace pliant {
namespace {

/// Row m, column n: the integral over the unit right triangle of basis function m of the field times n of det J.
std::vector<double> mixed_mass(int degree) {
  const NetLayout& of_field = NetLayout::of(degree);
  const NetLayout& of_jacobian = NetLayout::of(jacobian_degree(degree));
  const NetLayout& product = NetLayout::of(degree + jacobian_degree(degree));
  std::vector<double> mass;
  for (int m = 0; m < of_field.size(); ++m) {
    for (int n = 0; n < of_jacobian.size(); ++n) {
      const auto &e = of_field.exponents(m), &f = of_jacobian.exponents(n);
      mass.push_back(of_field.multinomial(m) * of_jacobian.multinomial(n) /
                     product.multinomial(product.index(e[0] + f[0], e[1] + f[1])) / (2 * product.size()));
    }
  }
  return mass;
}

/// The integrals of the basis functions over each chosen element.
std::vector<double> basis_integrals(const MeshData& data, std::span<const TriangleId> chosen) {
  const std::size_t n = index(net_size(data.degree)), m = index(net_size(jacobian_degree(data.degree)));
  const std::vector<double> mass = mixed_mass(data.degree);
  std::vector<double> result(n * chosen.size()), coefficients(m);
  std::vector<Point> net(n);
  for (std::size_t c = 0; c < chosen.size(); ++c) {
    const PointId* ids = &data.triangles[index(chosen[c]) * n];
    for (std::size_t k = 0; k < n; ++k) net[k] = data.points[index(ids[k])];
    jacobian_net(data.degree, net, coefficients);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 0; j < m; ++j) result[c * n + k] += mass[k * m + j] * coefficients[j];
  }
  return result;
}

/// Finds the row of a field's values that belongs to a control point, as seen from a face.
class Rows {
 public:
  explicit Rows(const Field& field) : by_face_(field.by_face) {
    for (std::size_t k = 0; by_face_ && k < field.places.size(); ++k)
      rows_[key(field.places[k][0], field.places[k][1])] = k;
  }
  /// What `find` returns if a field by face has no value at this point and face.
  static constexpr std::size_t npos = std::numeric_limits<std::size_t>::max();
  std::size_t find(PointId p, FaceId f) const {
    if (!by_face_) return static_cast<std::size_t>(p);
    const auto found = rows_.find(key(p, f));
    return found == rows_.end() ? npos : found->second;
  }

 private:
  static std::uint64_t key(std::int32_t p, std::int32_t f) {
    return static_cast<std::uint64_t>(p) << 32 | static_cast<std::uint32_t>(f);
  }
  bool by_face_;
  std::unordered_map<std::uint64_t, std::size_t> rows_;
};

}  // namespace

std::vector<FieldFigures> field_figures(const MeshData& data, std::span<const TriangleId> chosen) {
  std::vector<FieldFigures> result;
  if (data.fields.empty()) return result;
  const std::size_t n = index(net_size(data.degree));
  const std::vector<double> weights = basis_integrals(data, chosen);
  for (const Field& field : data.fields) {
    const std::size_t components = index(field.components);
    FieldFigures figures{field.name, std::vector<double>(components, HUGE_VAL),
                         std::vector<double>(components, -HUGE_VAL), std::vector<double>(components, 0.0)};
    const Rows rows(field);
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const std::size_t t = index(chosen[k / n]);
      const std::size_t row = rows.find(data.triangles[t * n + k % n], data.triangle_faces[t]);
      for (std::size_t c = 0; c < components; ++c) {
        const double value = row == Rows::npos ? nan : field.values[row * components + c];
        figures.integral[c] += weights[k] * value;
        if (std::isnan(value)) continue;
        figures.min[c] = std::min(figures.min[c], value);
        figures.max[c] = std::max(figures.max[c], value);
      }
    }
    for (std::size_t c = 0; c < components; ++c)
      if (figures.min[c] > figures.max[c]) figures.min[c] = figures.max[c] = figures.integral[c] = nan;
    result.push_back(std::move(figures));
  }
  return result;
}

}  // namespace pliant
