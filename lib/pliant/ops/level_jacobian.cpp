#include "pliant/ops/level_jacobian.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "pliant/geometry/jacobian.h"
#include "pliant/ops/move_and_refit.h"

namespace pliant {
namespace {

constexpr int most_halvings = 4;
constexpr int steps = 2;             // det J is bilinear in the points: the second step is small
constexpr double attachment = 1e-2;  // of a point to where it is, against det J's evenness, per edge length

/// The coefficients of det J of all elements, each divided by its element's mean.
void gather_ratios(const Mesh& mesh, std::span<const TriangleId> elements, Eigen::VectorXd& ratios) {
  std::array<Point, net_size(max_degree)> net;
  std::array<double, net_size(jacobian_degree(max_degree))> coefficients;
  const auto n = static_cast<std::size_t>(mesh.net_size());
  const auto m = static_cast<std::size_t>(net_size(jacobian_degree(mesh.degree())));
  ratios.resize(static_cast<Eigen::Index>(elements.size() * m));
  Eigen::Index row = 0;
  for (const TriangleId t : elements) {
    mesh.gather_points(t, net);
    jacobian_net(mesh.degree(), {net.data(), n}, {coefficients.data(), m});
    double mean = 0;
    for (std::size_t k = 0; k < m; ++k) mean += coefficients[k];
    mean /= static_cast<double>(m);
    for (std::size_t k = 0; k < m; ++k) ratios(row++) = coefficients[k] / mean;
  }
}

/// One Gauss-Newton step over the points, as long as it pays; `length` is that of the longest edge.
void level(Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> points, double length,
           double part) {
  thread_local Eigen::VectorXd ratios, moved, way;  // memory is reused from call to call
  thread_local Eigen::MatrixXd slopes, normal;
  thread_local Eigen::LDLT<Eigen::MatrixXd> factors;
  gather_ratios(mesh, elements, ratios);
  const auto unknowns = static_cast<Eigen::Index>(2 * points.size());
  slopes.resize(ratios.size(), unknowns);
  // A step of the size of the elements: the coefficients themselves are affine in each point.
  const double step = std::ldexp(length, -10);
  for (Eigen::Index u = 0; u < unknowns; ++u) {
    const PointId p = points[static_cast<std::size_t>(u / 2)];
    const Point place = mesh.point(p);
    mesh.set_point(p, place + (u % 2 == 0 ? Vector{step, 0} : Vector{0, step}));
    gather_ratios(mesh, elements, moved);
    slopes.col(u) = (moved - ratios) * (length / step);
    mesh.set_point(p, place);
  }
  normal.setIdentity(unknowns, unknowns);
  normal *= attachment;
  normal.noalias() += slopes.transpose().lazyProduct(slopes);
  ratios.array() = 1 - ratios.array();
  way.noalias() = slopes.transpose() * ratios;
  factors.compute(normal);
  factors.solveInPlace(way);
  if (!way.allFinite()) return;
  const double before = ratios.squaredNorm();
  const auto go = [&](double scale) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto u = static_cast<Eigen::Index>(2 * k);
      mesh.set_point(points[k], mesh.point(points[k]) + scale * Vector{way(u), way(u + 1)});
    }
  };
  double gone = part * length;
  go(gone);
  for (int halving = 0; halving < most_halvings; ++halving) {
    gather_ratios(mesh, elements, moved);
    if ((moved.array() - 1).matrix().squaredNorm() <= before) return;
    go(-gone / 2);
    gone /= 2;
  }
  go(-gone);
}

}  // namespace

Refusal level_jacobian(Mesh& mesh, TriangleId t, double part, const RefitOptions& options) {
  const int p = mesh.degree();
  std::array<TriangleId, 4> around{t};
  std::array<PointId, 3 * (max_degree - 1) + 4 * interior_size(max_degree)> points;
  std::size_t count = 1, free = 0;
  double length = 0;
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId h = half_edge(t, e);
    length = std::max(length, distance(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h))));
    if (mesh.is_constrained(h) || mesh.twin(h) == none) continue;
    around[count++] = triangle_of(mesh.twin(h));
    for (int k = 1; k < p; ++k) points[free++] = mesh.edge_point(h, k);
  }
  const std::span<const TriangleId> elements{around.data(), count};
  for (const TriangleId u : elements) {
    const InnerPoints inner = inner_points(mesh, u);
    for (int k = 0; k < interior_size(p); ++k) points[free++] = inner[static_cast<std::size_t>(k)];
  }
  if (free == 0) return Refusal::constrained;
  const std::span<const PointId> movable{points.data(), free};
  return move_and_refit(mesh, elements, movable, options, [&] {
    for (int k = 0; k < steps; ++k) level(mesh, elements, movable, length, part);
  });
}

}  // namespace pliant
