// lib/pliant/ops/even_jacobian.cpp: a Gauss-Newton step for the ratios of det J to its targets.
#include "pliant/ops/even_jacobian.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/dense/solve_dense.h"
#include "pliant/geometry/validity/jacobian.h"

namespace pliant {
namespace {

constexpr int most_halvings = 4;  // a step that did not help is tried at half its length so often
// The squared movement of a point, in lengths of the longest edge, counts this much beside the squares of the ratios.
constexpr double movement_weight = 1e-4;

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

/// One Gauss-Newton step towards ratios of 1. An object's memory is reused from step to step.
class EvenStep {
 public:
  bool run(Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> points,
           std::span<const double> targets, std::span<const double> weights, double part);

 private:
  void gather(std::vector<double>& ratios) const;
  /// The weighted sum of (ratio - 1)^2, which is to fall.
  double sum_of(const std::vector<double>& ratios) const;
  /// Finds, by differences, how the ratios change with the coordinates of the points.
  void find_slopes();
  /// Finds from the slopes where the points should go. False if the solution is not finite.
  bool find_way();
  /// Goes this far, or half as far and so on, until the sum falls. If it never does: false, and the points are back.
  bool go(double distance);
  void move(double distance);

  Mesh* mesh_ = nullptr;
  std::span<const TriangleId> elements_;
  std::span<const PointId> points_;
  std::span<const double> targets_;
  double length_ = 0;  // the length of the longest edge
  std::vector<double> ratios_, moved_, weights_;
  std::vector<double> slopes_;  // for each unknown the slopes of all ratios
  std::vector<double> normal_, way_;
};

bool EvenStep::run(Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> points,
                   std::span<const double> targets, std::span<const double> weights, double part) {
  mesh_ = &mesh;
  elements_ = elements;
  points_ = points;
  targets_ = targets;
  length_ = longest_edge(mesh, elements);
  weights_.assign(elements.size() * coefficients_of(mesh), 1.0);
  std::copy(weights.begin(), weights.end(), weights_.begin());
  gather(ratios_);
  find_slopes();
  return find_way() && go(part * length_);
}

void EvenStep::gather(std::vector<double>& ratios) const {
  ratios.resize(weights_.size());
  jacobian_ratios(*mesh_, elements_, targets_, ratios);
}

double EvenStep::sum_of(const std::vector<double>& ratios) const {
  double sum = 0;
  for (std::size_t i = 0; i < ratios.size(); ++i) sum += weights_[i] * (ratios[i] - 1) * (ratios[i] - 1);
  return sum;
}

void EvenStep::find_slopes() {
  const std::size_t count = ratios_.size(), unknowns = 2 * points_.size();
  slopes_.resize(count * unknowns);
  const double step = std::ldexp(length_, -10);
  for (std::size_t u = 0; u < unknowns; ++u) {
    const PointId p = points_[u / 2];
    const Point place = mesh_->point(p);
    mesh_->set_point(p, place + (u % 2 == 0 ? Vector{step, 0} : Vector{0, step}));
    gather(moved_);
    for (std::size_t i = 0; i < count; ++i) slopes_[u * count + i] = (moved_[i] - ratios_[i]) * (length_ / step);
    mesh_->set_point(p, place);
  }
}

bool EvenStep::find_way() {
  const std::size_t count = ratios_.size(), unknowns = 2 * points_.size();
  normal_.resize(unknowns * unknowns);
  way_.resize(unknowns);
  for (std::size_t u = 0; u < unknowns; ++u) {
    const double* const slope = slopes_.data() + u * count;
    way_[u] = 0;
    for (std::size_t i = 0; i < count; ++i) {
      moved_[i] = weights_[i] * slope[i];
      way_[u] += moved_[i] * (1 - ratios_[i]);
    }
    for (std::size_t v = 0; v <= u; ++v) {
      double sum = u == v ? movement_weight : 0;
      for (std::size_t i = 0; i < count; ++i) sum += moved_[i] * slopes_[v * count + i];
      normal_[u * unknowns + v] = normal_[v * unknowns + u] = sum;
    }
  }
  solve_dense(static_cast<int>(unknowns), normal_, 1, way_);
  return std::all_of(way_.begin(), way_.end(), [](double w) { return std::isfinite(w); });
}

void EvenStep::move(double distance) {
  for (std::size_t k = 0; k < points_.size(); ++k)
    mesh_->set_point(points_[k], mesh_->point(points_[k]) + distance * Vector{way_[2 * k], way_[2 * k + 1]});
}

bool EvenStep::go(double distance) {
  const double before = sum_of(ratios_);
  move(distance);
  for (int halving = 0;; ++halving) {
    gather(moved_);
    if (sum_of(moved_) < before) return true;
    if (halving == most_halvings) break;
    move(-distance / 2);
    distance /= 2;
  }
  move(-distance);
  return false;
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
  thread_local EvenStep step;
  return step.run(mesh, elements, points, targets, weights, part);
}

}  // namespace pliant
