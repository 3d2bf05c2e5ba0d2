// lib/pliant/improve/refining/refine_attack.cpp: compares a triangle with each bound of the goals.
#include "pliant/improve/refining/refine_attack.h"

#include <numbers>

#include "pliant/geometry/index.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/spline/turning_angle.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/improve/thin_gaps.h"

namespace pliant {
double edge_turning(const Mesh& mesh, HalfEdgeId h) {
  std::array<Point, max_degree + 1> polygon;
  mesh.gather_edge_points(h, polygon);
  return turning_angle({polygon.data(), index(mesh.degree() + 1)});
}

HalfEdgeId shortest_edge(const Mesh& mesh, TriangleId t) {
  const auto squared = [&](HalfEdgeId h) {
    return squared_length(mesh.point(mesh.target(h)) - mesh.point(mesh.origin(h)));
  };
  HalfEdgeId shortest = half_edge(t, 0);
  for (int e = 1; e < 3; ++e)
    if (squared(half_edge(t, e)) < squared(shortest)) shortest = half_edge(t, e);
  return shortest;
}

namespace {

/// By how much an edge on a curve is too long for the resolution wanted, as a factor; 0 where it is not.
double coarseness(const Mesh& mesh, HalfEdgeId h, double resolution) {
  const ConstraintId c = mesh.constraint(h);
  const double error = mesh.spline(mesh.constraint_curve(c)).resolution_error(mesh.constraint_start(c));
  return error > resolution ? std::pow(error / resolution, 1.0 / (mesh.degree() + 1)) : 0;
}

}  // namespace

Attack attack_on(const Mesh& mesh, TriangleId t, const QualityGoals& goals) {
  const Point &a = mesh.point(mesh.corner(t, 0)), &b = mesh.point(mesh.corner(t, 1)),
              &c = mesh.point(mesh.corner(t, 2));
  Attack attack;
  if (goals.max_turning < HUGE_VAL && mesh.degree() > 1)
    for (int e = 0; e < 3; ++e) {
      // Only edges on curves: inner edges are for smoothing.
      const HalfEdgeId h = half_edge(t, e);
      if (!mesh.is_constrained(h)) continue;
      const double ratio = edge_turning(mesh, h) / goals.max_turning;
      if (ratio > 1 && ratio > attack.excess) attack = {"too curved", ratio, h, false};
    }
  if (goals.resolution < HUGE_VAL)
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e);
      if (!mesh.is_constrained(h)) continue;
      const double ratio = coarseness(mesh, h, goals.resolution);
      if (ratio > 1 && ratio > attack.excess) attack = {"too curved", ratio, h, false};
    }
  // Whatever is asked of curves above, QuickGoals::are_surely_met has to know it, too.
  if (attack.reason) return attack;
  const double bound = goals.area_bound(mesh.face(t));
  if (bound < HUGE_VAL) {
    std::array<Point, net_size(max_degree)> net;
    mesh.gather_points(t, net);
    const double ratio = element_area(mesh.degree(), {net.data(), index(mesh.net_size())}) / bound;
    if (ratio > 1) return {"too large", ratio, none, false};
  }
  if (goals.size || goals.size_field != none) {
    double wanted = goals.length_at((1.0 / 3) * (a + b + c), mesh.time);
    if (goals.size_field != none) {
      double sum = 0;
      for (int k = 0; k < 3; ++k) sum += goals.length_by_field(mesh, t, k);
      wanted = std::min(wanted, sum / 3);
    }
    const double longest = std::sqrt(std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)}));
    if (longest > size_slack * wanted) return {"too large", longest / (size_slack * wanted), none, false};
  }
  if (goals.min_angle > 0) {
    const double limit = 1 / (2 * std::sin(goals.min_angle * std::numbers::pi / 180));
    const double ratio =
        cross(b - a, c - a) > 0 ? radius_edge_ratio(a, b, c) : HUGE_VAL;  // turned over: as poor as can be
    const auto is_kept = [&] { return goals.keeps_thin && crosses_thin_gap(mesh, shortest_edge(mesh, t)); };
    if (ratio > limit && !is_kept()) return {"too poor", ratio / limit, none, true};
  }
  return {};
}

}  // namespace pliant
