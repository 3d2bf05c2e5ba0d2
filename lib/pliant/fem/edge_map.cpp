// lib/pliant/fem/edge_map.cpp: Gauss rules along edges.
#include "pliant/fem/edge_map.h"

#include <algorithm>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"

namespace pliant {

std::vector<std::vector<HalfEdgeId>> curve_edges(const Mesh& mesh) {
  std::vector<std::vector<HalfEdgeId>> edges(mesh.boundary().curves.size());
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (!mesh.is_constrained(h)) continue;
    if (mesh.runs_forward(h) || mesh.twin(h) == none)
      edges[index(mesh.constraint_curve(mesh.constraint(h)))].push_back(h);
  }
  return edges;
}

EdgeMap::EdgeMap(int degree) : degree_(degree), rule_(segment_rule(std::min(4 * degree + 4, 40))) {
  const std::size_t n = index(degree) + 1;
  values_.resize(rule_.size() * n);
  derivatives_.assign(rule_.size() * n, 0.0);
  measures_.resize(rule_.size());
  along_.resize(rule_.size());
  polygon_.resize(n);
  std::vector<double> lower(n - 1);
  for (std::size_t q = 0; q < rule_.size(); ++q) {
    bernstein_basis(degree, rule_[q].s, std::span(values_).subspan(q * n, n));
    bernstein_basis(degree - 1, rule_[q].s, lower);
    for (std::size_t k = 0; k + 1 < n; ++k) {
      derivatives_[q * n + k] -= degree * lower[k];
      derivatives_[q * n + k + 1] += degree * lower[k];
    }
  }
}

void EdgeMap::set(const Mesh& mesh, std::span<const Point> points, HalfEdgeId h) {
  const std::size_t n = polygon_.size();
  edge_ = edge_of(h);
  for (int k = 0; k <= degree_; ++k) polygon_[index(k)] = points[index(mesh.edge_point(h, k))];
  for (std::size_t q = 0; q < rule_.size(); ++q) {
    Vector along;
    for (std::size_t k = 0; k < n; ++k) along += derivatives_[q * n + k] * polygon_[k];
    along_[q] = along;
    measures_[q] = rule_[q].weight * length(along);
  }
}

std::span<const double> EdgeMap::values_at(int q) const {
  return std::span(values_).subspan(index(q) * polygon_.size(), polygon_.size());
}

std::span<const double> EdgeMap::derivatives_at(int q) const {
  return std::span(derivatives_).subspan(index(q) * polygon_.size(), polygon_.size());
}

Point EdgeMap::place(int q) const {
  Point place;
  const auto values = values_at(q);
  for (std::size_t k = 0; k < polygon_.size(); ++k) place += values[k] * polygon_[k];
  return place;
}

Barycentric EdgeMap::xi(int q) const {
  Barycentric xi{0, 0, 0};
  xi[index(edge_)] = 1 - rule_[index(q)].s;
  xi[index((edge_ + 1) % 3)] = rule_[index(q)].s;
  return xi;
}

}  // namespace pliant
