// lib/pliant/ops/refit/fit_displacement.cpp: fits the displacements of new elements to those of the old ones.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/dense/solve_dense.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/node_basis.h"
#include "pliant/ops/refit/refit.h"
#include "pliant/ops/refit/straight_places.h"
#include "pliant/ops/refit/third_derivatives.h"

namespace pliant {
namespace {

/// How much third derivatives count beside values, in lengths of the patch: so much that they are fitted first. Fitted
/// values alone would leave them as large as if second derivatives jumped, since the maps of two elements differ by a
/// part of first order; elements of degree 3 and more would lose their order.
constexpr double third_share = 1e2;
/// The least shape of the straight triangles of a patch for which they are fitted: some 8 degrees.
constexpr double least_shape = 0.2;

/// The third derivatives of the displacement of some elements; used again, so that it need not allocate.
class DisplacementThirds {
 public:
  void start(int degree) {
    degree_ = degree;
    differences_.clear();
    planes_.clear();
  }

  /// Adds an element with the straight triangle a, b, c.
  void add(const Point& a, const Point& b, const Point& c, std::span<const double> displacement) {
    const std::size_t size = 8 * lower();
    differences_.resize(size * (planes_.size() + 1));
    third_differences(degree_, displacement, std::span(differences_).last(size));
    planes_.emplace_back(a, b, c);
  }
  /// Along x and y, at a point of element e.
  std::array<Vector, 4> at(std::size_t e, const Barycentric& xi) const {
    std::array<double, net_size(max_degree)> basis;
    bernstein_basis(degree_ - 3, xi, std::span(basis).first(lower()));
    const double* from = differences_.data() + e * 8 * lower();
    Thirds x{}, y{};
    for (std::size_t m = 0; m < 4; ++m) {
      for (std::size_t q = 0; q < lower(); ++q) x[m] += basis[q] * *from++;
      for (std::size_t q = 0; q < lower(); ++q) y[m] += basis[q] * *from++;
    }
    x = planes_[e](x);
    y = planes_[e](y);
    return {Vector{x[0], y[0]}, Vector{x[1], y[1]}, Vector{x[2], y[2]}, Vector{x[3], y[3]}};
  }

 private:
  std::size_t lower() const { return index(pliant::net_size(degree_ - 3)); }
  int degree_ = 3;
  std::vector<double> differences_;
  std::vector<ThirdsInPlane> planes_;
};

}  // namespace

void Patch::fit_displacement(const Mesh& mesh, std::span<const TriangleId> now, std::span<const PointId> free,
                             std::span<const double> displacement, std::span<Vector> solution) const {
  const NetLayout& layout = NetLayout::of(degree_);
  const NodeBasis& table = node_basis(degree_);
  const int unknowns = static_cast<int>(free.size());
  thread_local std::vector<double> normal, right;
  normal.assign(index(unknowns * unknowns), 0.0);
  right.assign(index(2 * unknowns), 0.0);
  std::array<Vector, net_size(max_degree)> known;
  std::array<std::pair<int, int>, net_size(max_degree)> unknown;  // place in the net, number
  std::array<double, net_size(max_degree)> old_basis;
  // In thin triangles third derivatives across are all rounding, or all that counts.
  const auto is_shapely = [](const Point& a, const Point& b, const Point& c) {
    return triangle_shape(a, b, c) >= least_shape;
  };
  const bool fits_thirds =
      degree_ > 2 &&
      std::all_of(elements_.begin(), elements_.end(),
                  [&](const Element& e) { return is_shapely(old_point(e, 0), old_point(e, 1), old_point(e, 2)); }) &&
      std::all_of(now.begin(), now.end(), [&](TriangleId t) {
        return is_shapely(mesh.point(mesh.corner(t, 0)), mesh.point(mesh.corner(t, 1)), mesh.point(mesh.corner(t, 2)));
      });
  thread_local DisplacementThirds old_thirds;
  old_thirds.start(degree_);
  if (fits_thirds)
    for (std::size_t e = 0; e < elements_.size(); ++e)
      old_thirds.add(old_point(elements_[e], 0), old_point(elements_[e], 1), old_point(elements_[e], 2),
                     displacement.subspan(e * index(2 * n_), index(2 * n_)));
  double region = 0;
  for (const TriangleId t : now) {
    const auto net = mesh.net(t);
    region += triangle_area(mesh.point(net[0]), mesh.point(net[1]), mesh.point(net[2]));
  }
  const double third_weight = third_share * region * region * region;
  for (const TriangleId t : now) {
    const auto net = mesh.net(t);
    const Point a = mesh.point(net[0]), b = mesh.point(net[1]), c = mesh.point(net[2]);
    std::size_t own = 0;            // unknowns in this element
    for (int k = 3; k < n_; ++k) {  // corners are where the straight triangle has them
      const int u = index_in(free, net[index(k)]);
      if (u >= 0) unknown[own++] = {k, u};
      known[index(k)] = u < 0 ? mesh.point(net[index(k)]) - straight(layout, k, a, b, c) : Vector{};
    }
    const double area = triangle_area(a, b, c);
    std::optional<ThirdsInPlane> in_plane;
    if (fits_thirds) in_plane.emplace(a, b, c);
    for (std::size_t node = 0; node < table.nodes.size(); ++node) {
      const Barycentric& at_node = table.nodes[node].xi;
      const Point x = at_node[0] * a + at_node[1] * b + at_node[2] * c;
      std::size_t best = 0;
      double depth = -HUGE_VAL;
      Barycentric best_xi{};
      for (std::size_t e = 0; e < elements_.size() && depth < 0; ++e) {
        const Element& old = elements_[e];
        const Barycentric xi = barycentric(old_point(old, 0), old_point(old, 1), old_point(old, 2), x);
        const double least = std::min({xi[0], xi[1], xi[2]});
        if (least > depth) depth = least, best = e, best_xi = xi;
      }
      if (degree_ == 2) {
        const auto& [u, v, w] = best_xi;
        old_basis[3] = 2 * u * v, old_basis[4] = 2 * v * w, old_basis[5] = 2 * w * u;
      } else {
        bernstein_basis(degree_, best_xi, old_basis);
      }
      const double* const old = displacement.data() + best * index(2 * n_);
      const std::span<const double> basis = table.at(node);
      Vector rest{};
      for (int k = 3; k < n_; ++k)
        rest += old_basis[index(k)] * Vector{old[2 * k], old[2 * k + 1]} - basis[index(k)] * known[index(k)];
      const double weight = table.nodes[node].weight * area;
      for (std::size_t i = 0; i < own; ++i) {
        const auto& [k, u] = unknown[i];
        const double share = weight * basis[index(k)];
        right[index(2 * u)] += share * rest.x;
        right[index(2 * u + 1)] += share * rest.y;
        for (std::size_t j = 0; j < own; ++j)
          normal[index(u * unknowns + unknown[j].second)] += share * basis[index(unknown[j].first)];
      }
      if (!fits_thirds) continue;
      const Thirds* const thirds = &thirds_at_nodes(degree_)[node * index(n_)];
      std::array<Vector, 4> lacks = old_thirds.at(best, best_xi);
      Thirds x_known{}, y_known{};
      for (int k = 3; k < n_; ++k)
        for (std::size_t m = 0; m < 4; ++m) {
          x_known[m] += thirds[k][m] * known[index(k)].x;
          y_known[m] += thirds[k][m] * known[index(k)].y;
        }
      x_known = (*in_plane)(x_known);
      y_known = (*in_plane)(y_known);
      std::array<Thirds, net_size(max_degree)> own_thirds;
      for (std::size_t i = 0; i < own; ++i) own_thirds[i] = (*in_plane)(thirds[unknown[i].first]);
      for (std::size_t m = 0; m < 4; ++m) {
        lacks[m] -= Vector{x_known[m], y_known[m]};
        for (std::size_t i = 0; i < own; ++i) {
          const int u = unknown[i].second;
          const double share = weight * third_weight * third_counts[m] * own_thirds[i][m];
          right[index(2 * u)] += share * lacks[m].x;
          right[index(2 * u + 1)] += share * lacks[m].y;
          for (std::size_t j = 0; j < own; ++j)
            normal[index(u * unknowns + unknown[j].second)] += share * own_thirds[j][m];
        }
      }
    }
  }
  solve_dense(unknowns, normal, 2, right);
  for (int u = 0; u < unknowns; ++u) solution[index(u)] = {right[index(2 * u)], right[index(2 * u + 1)]};
}

}  // namespace pliant
