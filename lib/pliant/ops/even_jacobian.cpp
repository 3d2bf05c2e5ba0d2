#include "pliant/ops/even_jacobian.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/jacobian.h"
#include "pliant/ops/solve_dense.h"

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
  thread_local std::vector<double> ratios, moved, weight, slopes, normal, way;
  const std::size_t count = elements.size() * coefficients_of(mesh), unknowns = 2 * points.size();
  const auto gather = [&](std::vector<double>& into) {
    into.resize(count);
    jacobian_ratios(mesh, elements, targets, into);
  };
  weight.assign(count, 1.0);
  std::copy(weights.begin(), weights.end(), weight.begin());
  const auto sum_of = [&](const std::vector<double>& r) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += weight[i] * (r[i] - 1) * (r[i] - 1);
    return sum;
  };

  gather(ratios);
  slopes.resize(count * unknowns);  // one unknown after the other
  const double length = longest_edge(mesh, elements);
  const double step = std::ldexp(length, -10);
  for (std::size_t u = 0; u < unknowns; ++u) {
    const PointId p = points[u / 2];
    const Point place = mesh.point(p);
    mesh.set_point(p, place + (u % 2 == 0 ? Vector{step, 0} : Vector{0, step}));
    gather(moved);
    for (std::size_t i = 0; i < count; ++i) slopes[u * count + i] = (moved[i] - ratios[i]) * (length / step);
    mesh.set_point(p, place);
  }
  normal.resize(unknowns * unknowns);
  way.resize(unknowns);
  for (std::size_t u = 0; u < unknowns; ++u) {
    const double* const slope = slopes.data() + u * count;
    way[u] = 0;
    for (std::size_t i = 0; i < count; ++i) {
      moved[i] = weight[i] * slope[i];
      way[u] += moved[i] * (1 - ratios[i]);
    }
    for (std::size_t v = 0; v <= u; ++v) {
      double sum = u == v ? attachment : 0;
      for (std::size_t i = 0; i < count; ++i) sum += moved[i] * slopes[v * count + i];
      normal[u * unknowns + v] = normal[v * unknowns + u] = sum;
    }
  }
  solve_dense(static_cast<int>(unknowns), normal, 1, way);
  if (!std::all_of(way.begin(), way.end(), [](double w) { return std::isfinite(w); })) return false;

  const double before = sum_of(ratios);
  const auto go = [&](double scale) {
    for (std::size_t k = 0; k < points.size(); ++k)
      mesh.set_point(points[k], mesh.point(points[k]) + scale * Vector{way[2 * k], way[2 * k + 1]});
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
