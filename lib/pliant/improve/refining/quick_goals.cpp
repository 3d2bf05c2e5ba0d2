// lib/pliant/improve/refining/quick_goals.cpp: areas and least angles without roots, with margins for rounding.
#include "pliant/improve/refining/quick_goals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "pliant/geometry/index.h"
#include "pliant/geometry/spline/turning_angle.h"
#include "pliant/geometry/validity/jacobian.h"

namespace pliant {
namespace {

constexpr double angle_margin = 1e-9;  // relative, for the least angle: squares and roots differ by some 1e-15
constexpr double rounding = 1e-12;     // of areas, in squared lengths: both ways to compute them differ by some 1e-14

}  // namespace

QuickGoals::QuickGoals(const Mesh& mesh, const QualityGoals& goals) : mesh_(mesh), goals_(goals) {
  for (FaceId f = 0; f < static_cast<FaceId>(mesh.boundary().faces.size()); ++f)
    area_bounds_.push_back(goals.area_bound(f));
  const double sine = std::sin(goals.min_angle * std::numbers::pi / 180);
  if (goals.min_angle > 0) squared_sine_ = sine * sine * (1 + angle_margin);
  bounds_turning_ = goals.max_turning < HUGE_VAL && mesh.degree() > 1;
  if (bounds_turning_) least_cosine_ = std::cos(std::min(goals.max_turning / (mesh.degree() - 1), std::numbers::pi));
  bounds_resolution_ = goals.resolution < HUGE_VAL;
  is_known_ = !goals.size && goals.size_field == none;
}

/// Do the edges on curves surely turn by no more than they may? No leg of their polygons turns too much from the last.
bool QuickGoals::turns_surely_little(TriangleId t) const {
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId h = half_edge(t, e);
    if (!mesh_.is_constrained(h)) continue;
    const auto leg = [&](int k) {
      return mesh_.point(mesh_.edge_point(h, k + 1)) - mesh_.point(mesh_.edge_point(h, k));
    };
    for (int k = 1; k < mesh_.degree(); ++k)
      if (!is_turn_within(leg(k - 1), leg(k), least_cosine_)) return false;
  }
  return true;
}

bool QuickGoals::are_surely_met(TriangleId t) const {
  if (!is_known_) return false;
  const HalfEdgeId h = half_edge(t, 0);
  if ((bounds_turning_ || bounds_resolution_) &&
      (mesh_.is_constrained(h) || mesh_.is_constrained(next(h)) || mesh_.is_constrained(previous(h))) &&
      (bounds_resolution_ || !turns_surely_little(t)))
    return false;
  const auto net = mesh_.net(t);
  const Point &a = mesh_.point(net[0]), &b = mesh_.point(net[1]), &c = mesh_.point(net[2]);
  const Vector ab = b - a, bc = c - b, ca = a - c;
  const double left = ab.x * ca.y, right = ab.y * ca.x, twice_area = right - left;
  const double lengths[3] = {squared_length(ab), squared_length(bc), squared_length(ca)};
  const double squares = lengths[0] + lengths[1] + lengths[2];
  if (!(twice_area > rounding * squares)) return false;
  const double least = std::min({lengths[0], lengths[1], lengths[2]});
  const double product = least == lengths[0]   ? lengths[1] * lengths[2]
                         : least == lengths[1] ? lengths[0] * lengths[2]
                                               : lengths[0] * lengths[1];
  // The least angle lies opposite the shortest side, and its sine is twice the area over the product of the two others.
  if (!(product > 1e-280 && product < 1e280 && twice_area * twice_area > squared_sine_ * product)) return false;

  const double bound = area_bounds_[index(mesh_.face(t))];
  if (!(bound < HUGE_VAL)) return true;
  if (mesh_.degree() > 2) {
    std::array<Point, net_size(max_degree)> points;
    mesh_.gather_points(t, points);
    return element_area(mesh_.degree(), {points.data(), net.size()}) <= bound;
  }
  double twice = twice_area, sizes = squares;
  if (mesh_.degree() == 2) {  // a parabola's segment has two thirds of the area of the triangle around it
    const Vector p = mesh_.point(net[3]) - a, q = mesh_.point(net[4]) - b, r = mesh_.point(net[5]) - c;
    twice += 2.0 / 3 * (cross(p, ab) + cross(q, bc) + cross(r, ca));
    sizes += squared_length(p) + squared_length(q) + squared_length(r);
  }
  return twice / 2 + rounding * sizes <= bound;
}

}  // namespace pliant
