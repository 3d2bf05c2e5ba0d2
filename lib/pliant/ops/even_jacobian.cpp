#include "pliant/ops/even_jacobian.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/jacobian.h"

namespace pliant {
namespace {

constexpr int most_halvings = 4;
constexpr double attachment = 1e-4;  // of a point to where it is, against the ratios, per length of the longest edge

double longest_edge(const Mesh& mesh, std::span<const TriangleId> elements) {
  double longest = 0;
  for (const TriangleId t : elements)
    for (int e = 0; e < 3; ++e)
      longest = std::max(longest, distance(mesh.point(mesh.corner(t, e)), mesh.point(mesh.corner(t, (e + 1) % 3))));
  return longest;
}

std::size_t coefficients_of(const Mesh& mesh) {
  return static_cast<std::size_t>(net_size(jacobian_degree(mesh.degree())));
}

}  // namespace

void jacobian_ratios(const Mesh& mesh, std::span<const TriangleId> elements, std::span<const double> targets,
                     std::span<double> ratios) {
  std::array<Point, net_size(max_degree)> net;
  const std::size_t m = coefficients_of(mesh);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    mesh.gather_points(elements[e], net);
    const std::span<double> own = ratios.subspan(e * m, m);
    jacobian_net(mesh.degree(), {net.data(), static_cast<std::size_t>(mesh.net_size())}, own);
    for (double& c : own) c /= targets[e];
  }
}

bool step_to_even_jacobian(Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> points,
                           std::span<const double> targets, std::span<const double> weights, double part) {
  thread_local Eigen::VectorXd ratios, moved, weight, way;
  thread_local Eigen::MatrixXd slopes, weighted, normal;
  thread_local Eigen::LDLT<Eigen::MatrixXd> factors;
  const auto count = static_cast<Eigen::Index>(elements.size() * coefficients_of(mesh));
  const auto unknowns = static_cast<Eigen::Index>(2 * points.size());
  const auto gather = [&](Eigen::VectorXd& into) {
    into.resize(count);
    jacobian_ratios(mesh, elements, targets, {into.data(), static_cast<std::size_t>(count)});
  };
  if (weights.empty())
    weight.setOnes(count);
  else
    weight = Eigen::Map<const Eigen::VectorXd>(weights.data(), count);
  const auto sum_of = [&](const Eigen::VectorXd& r) { return (weight.array() * (r.array() - 1).square()).sum(); };

  gather(ratios);
  slopes.resize(count, unknowns);
  const double length = longest_edge(mesh, elements);
  const double step = std::ldexp(length, -10);
  for (Eigen::Index u = 0; u < unknowns; ++u) {
    const PointId p = points[static_cast<std::size_t>(u / 2)];
    const Point place = mesh.point(p);
    mesh.set_point(p, place + (u % 2 == 0 ? Vector{step, 0} : Vector{0, step}));
    gather(moved);
    slopes.col(u) = (moved - ratios) * (length / step);
    mesh.set_point(p, place);
  }
  weighted = weight.asDiagonal() * slopes;
  normal.setIdentity(unknowns, unknowns);
  normal *= attachment;
  normal.noalias() += slopes.transpose().lazyProduct(weighted);
  way.noalias() = weighted.transpose() * (1 - ratios.array()).matrix();
  factors.compute(normal);
  factors.solveInPlace(way);
  if (!way.allFinite()) return false;

  const double before = sum_of(ratios);
  const auto go = [&](double scale) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto u = static_cast<Eigen::Index>(2 * k);
      mesh.set_point(points[k], mesh.point(points[k]) + scale * Vector{way(u), way(u + 1)});
    }
  };
  double gone = part * length;
  go(gone);
  for (int halving = 0;; ++halving) {
    gather(moved);
    if (sum_of(moved) < before) return true;
    if (halving == most_halvings) break;
    go(-gone / 2);
    gone /= 2;
  }
  go(-gone);
  return false;
}

}  // namespace pliant
