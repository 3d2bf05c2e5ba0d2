// lib/pliant/improve/global/deformation_energy.cpp: nodes and weights, the squares of the energy, their derivatives.
#include "pliant/improve/global/deformation_energy.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

struct Node {
  Barycentric xi;
  double weight;  // all weights add up to 1
};

/// The nodes of a lattice: on each of its triangles the corners have the weight 1/12 and the centre 3/4, in parts of
/// the triangle's area. The element's own corners come first.
std::vector<Node> nodes_of(int subdivisions) {
  const int n = subdivisions;
  const double part = 1.0 / (n * n);
  std::vector<Node> corners, nodes;
  std::vector<double> weights(index((n + 1) * (n + 1)), 0.0);
  const auto add_triangle = [&](std::array<std::array<int, 2>, 3> t) {
    double x = 0, y = 0;
    for (const auto& [i, j] : t) {
      weights[index(i * (n + 1) + j)] += part / 12;
      x += i / (3.0 * n), y += j / (3.0 * n);
    }
    nodes.push_back({{x, y, 1 - x - y}, 0.75 * part});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      add_triangle({{{i, j}, {i + 1, j}, {i, j + 1}}});
      if (i + j + 1 < n) add_triangle({{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}}});
    }
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const int k = n - i - j;
      const Node node{{i / double(n), j / double(n), k / double(n)}, weights[index(i * (n + 1) + j)]};
      (std::max({i, j, k}) == n ? corners : nodes).push_back(node);
    }
  std::sort(corners.begin(), corners.end(), [](const Node& a, const Node& b) { return a.xi > b.xi; });
  nodes.insert(nodes.begin(), corners.begin(), corners.end());
  return nodes;
}

/// The gradient F of the map at a node.
struct Gradient {
  double xx, xy, yx, yy, det;
  /// The derivative of det F by a control point whose basis function has this gradient in the wanted triangle.
  Vector det_by(const Vector& g) const { return {yy * g.x - yx * g.y, xx * g.y - xy * g.x}; }
};

constexpr std::size_t most_nodes = net_size(2 * max_degree) + 4 * max_degree * max_degree;
constexpr double root_of_evenness = 2;

}  // namespace

WantedShape WantedShape::of(const Vector& u, const Vector& v) {
  const double det = cross(u, v);
  return {v.y / det, -v.x / det, -u.y / det, u.x / det};
}

const DeformationEnergy& DeformationEnergy::of(int degree, Nodes nodes) {
  static std::mutex mutex;
  static std::array<std::array<std::unique_ptr<const DeformationEnergy>, 2>, max_degree> made;
  const std::lock_guard lock(mutex);
  auto& energy = made[index(degree - 1)][nodes == Nodes::few ? 0 : 1];
  if (!energy) energy.reset(new DeformationEnergy(degree, nodes == Nodes::few ? std::max(1, degree - 1) : 2 * degree));
  return *energy;
}

DeformationEnergy::DeformationEnergy(int degree, int subdivisions) : degree_(degree) {
  const int n = net_size(degree);
  std::vector<double> identity(index(n * n), 0.0), value(index(n)), along_2(index(n)), along_3(index(n));
  for (int k = 0; k < n; ++k) identity[index(k * n + k)] = 1;
  for (const Node& node : nodes_of(subdivisions)) {
    evaluate_net(degree, n, identity, node.xi, value, along_2, along_3);
    for (int k = 0; k < n; ++k) slopes_.push_back({along_2[index(k)], along_3[index(k)]});
    weights_.push_back(node.weight);
  }
}

bool DeformationEnergy::evaluate(std::span<const Point> net, const Target& target, std::span<double> residuals,
                                 std::span<const std::int8_t> moving, double* jacobian) const {
  const WantedShape& wanted = target.shape;
  const auto n = index(net_size(degree_)), count = moving.size();
  std::array<Gradient, most_nodes> gradients;
  std::array<Vector, net_size(max_degree)> mean_by{};  // derivatives of the mean by the moving points
  double mean = 0;
  for (std::size_t q = 0; q < weights_.size(); ++q) {
    const Vector* const slope = slopes_.data() + q * n;
    Vector along_2, along_3;
    for (std::size_t k = 0; k < n; ++k) along_2 += slope[k].x * net[k], along_3 += slope[k].y * net[k];
    Gradient& f = gradients[q];
    f.xx = along_2.x * wanted.xx + along_3.x * wanted.yx, f.xy = along_2.x * wanted.xy + along_3.x * wanted.yy;
    f.yx = along_2.y * wanted.xx + along_3.y * wanted.yx, f.yy = along_2.y * wanted.xy + along_3.y * wanted.yy;
    f.det = f.xx * f.yy - f.xy * f.yx;
    if (!target.any_area) continue;
    mean += weights_[q] * f.det;
    if (!jacobian) continue;
    for (std::size_t m = 0; m < count; ++m) mean_by[m] += weights_[q] * f.det_by(wanted.gradient(slope[moving[m]]));
  }
  if (!target.any_area) mean = 1;
  if (!(mean > 0)) return false;
  for (std::size_t q = 0; q < weights_.size(); ++q) {
    double* const r = residuals.data() + q * residuals_each;
    double* const rows = jacobian ? jacobian + q * residuals_each * count * 2 : nullptr;
    if (q < 3 && (target.forgiven >> q & 1u)) {
      std::fill_n(r, residuals_each, 0.0);
      if (rows) std::fill_n(rows, residuals_each * count * 2, 0.0);
      continue;
    }
    const Gradient& f = gradients[q];
    const double e = target.smoothing, root = e > 0 ? std::sqrt(e * e + f.det * f.det) : std::fabs(f.det);
    // (det + root) / 2, without cancellation where det is negative.
    const double shifted = f.det > 0 ? (f.det + root) / 2 : e * e / (2 * (root - f.det));
    if (!(shifted > 0) || !std::isfinite(shifted)) return false;
    const double s = 1 / std::sqrt(shifted), u = shifted / mean, v = 1 / std::sqrt(u), w = std::sqrt(weights_[q]);
    r[0] = w * (f.xx - f.yy) * s;
    r[1] = w * (f.xy + f.yx) * s;
    r[2] = root_of_evenness * w * (1 / v - v);
    if (!rows) continue;
    const double change = shifted / root;  // the derivative of `shifted` by det
    const double fall = -0.5 * s * s * change, rise = 0.5 * root_of_evenness * w * v * (1 + v * v) / mean, ws = w * s;
    const Vector* const slope = slopes_.data() + q * n;
    for (std::size_t m = 0; m < count; ++m) {
      const Vector g = wanted.gradient(slope[moving[m]]), by = f.det_by(g);
      double *const a = rows + 2 * m, *const b = a + 2 * count, *const c = b + 2 * count;
      a[0] = ws * g.x + r[0] * fall * by.x;
      a[1] = -ws * g.y + r[0] * fall * by.y;
      b[0] = ws * g.y + r[1] * fall * by.x;
      b[1] = ws * g.x + r[1] * fall * by.y;
      c[0] = rise * (change * by.x - u * mean_by[m].x);
      c[1] = rise * (change * by.y - u * mean_by[m].y);
    }
  }
  return true;
}

}  // namespace pliant
