// lib/pliant/fem/element_map.cpp: chooses the rule, and evaluates the map's derivatives at its points.
#include "pliant/fem/element_map.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/jacobian.h"

namespace pliant {
namespace {

constexpr double much_varying = 0.7;  // where min J / max J is below, the stiffness needs more points

/// Are the control points those of an affine map, up to some bits of the element's size?
bool is_affine(int degree, std::span<const Point> net) {
  const NetLayout& layout = NetLayout::of(degree);
  const Vector to_2 = net[1] - net[0], to_3 = net[2] - net[0];
  const double size = std::max({std::abs(to_2.x), std::abs(to_2.y), std::abs(to_3.x), std::abs(to_3.y)});
  const double reach = std::max(std::abs(net[0].x), std::abs(net[0].y));
  const double allowed = 0x1p-50 * (size + reach);
  for (int k = 3; k < layout.size(); ++k) {
    const auto& exponents = layout.exponents(k);
    const Point straight = net[0] + (exponents[1] * to_2 + exponents[2] * to_3) / degree;
    const Vector off = net[index(k)] - straight;
    if (std::abs(off.x) > allowed || std::abs(off.y) > allowed) return false;
  }
  return true;
}

}  // namespace

void ElementMap::gather(const Mesh& mesh, std::span<const Point> points, TriangleId t) {
  std::size_t k = 0;
  for (const PointId p : mesh.net(t)) net_[k++] = points[index(p)];
}

void ElementMap::set(const Mesh& mesh, std::span<const Point> points, TriangleId t, Integrand integrand) {
  gather(mesh, points, t);
  affine_ = pliant::is_affine(degree_, net_);
  int exact = 4 * degree_ - 2;
  if (affine_) {
    if (integrand == Integrand::constant) exact = 2 * degree_;
  } else {
    jacobian_.resize(index(net_size(jacobian_degree(degree_))));
    jacobian_net(degree_, net_, jacobian_);
    const auto [least, greatest] = std::ranges::minmax(jacobian_);
    if (!(least >= much_varying * greatest)) exact = std::min(4 * degree_ + 4, greatest_exact_degree);
  }
  table_ = &element_table(degree_, exact);
  map();
}

void ElementMap::set(const Mesh& mesh, std::span<const Point> points, TriangleId t, const ElementTable& table) {
  gather(mesh, points, t);
  affine_ = pliant::is_affine(degree_, net_);
  table_ = &table;
  map();
}

void ElementMap::map() {
  const std::size_t m = index(table_->points), n = net_.size();
  det_.resize(m);
  along_2_.resize(m);
  along_3_.resize(m);
  const double* d2 = table_->along_2.data();
  const double* d3 = table_->along_3.data();
  for (std::size_t q = 0; q < m; ++q, d2 += n, d3 += n) {
    Vector to_2, to_3;
    for (std::size_t k = 0; k < n; ++k) {
      to_2 += d2[k] * net_[k];
      to_3 += d3[k] * net_[k];
    }
    along_2_[q] = to_2;
    along_3_[q] = to_3;
    det_[q] = cross(to_2, to_3);
  }
}

Point ElementMap::place(int q) const {
  Point place;
  const auto values = table_->values_at(q);
  for (std::size_t k = 0; k < net_.size(); ++k) place += values[k] * net_[k];
  return place;
}

}  // namespace pliant
