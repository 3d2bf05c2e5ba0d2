// lib/pliant/improve/refining/left_by_refine.cpp: runs refine on copies, and compares triangles by the places of their
// corners.
#include "pliant/improve/refining/left_by_refine.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/linear_triangle.h"
#include "pliant/improve/refine.h"
#include "pliant/improve/refining/quick_goals.h"
#include "pliant/improve/triangle_budget.h"

namespace pliant {
namespace {

constexpr long many = 1000;  // after so many insertions refine has much to do anyway, and need not come to rest

/// How much refine has inserted; `too_much`: it has given up at its limit of triangles.
enum class Refined { nothing, some, much, too_much };

Refined refine_copy(Mesh& mesh, const QualityGoals& goals) {
  RefineOptions options;
  options.goals = goals;
  options.max_insertions = many;
  const int before = mesh.triangle_count();
  try {
    refine(mesh, options);
  } catch (const TooManyTriangles&) {
    return Refined::too_much;  // the copy is of no use now
  }
  const long more = mesh.triangle_count() - before;
  return more == 0 ? Refined::nothing : more < many ? Refined::some : Refined::much;
}

std::set<std::array<double, 2>> vertices_of(const Mesh& mesh) {
  std::set<std::array<double, 2>> places;
  for (PointId v = 0; v < mesh.point_slots(); ++v)
    if (mesh.is_vertex(v)) places.insert({mesh.point(v).x, mesh.point(v).y});
  return places;
}

}  // namespace

LeftByRefine::LeftByRefine(const Mesh& before, const QualityGoals& goals) : goals_(goals) {
  const QuickGoals quick(before, goals);
  for (TriangleId t = 0; t < before.triangle_slots(); ++t)
    if (before.is_alive(t) && quick.attack_on(t).reason) attacked_.insert(corners_of(before, t));
}

LeftByRefine::Corners LeftByRefine::corners_of(const Mesh& mesh, TriangleId t) {
  std::array<std::array<double, 2>, 3> places;
  for (int c = 0; c < 3; ++c) {
    const Point& p = mesh.point(mesh.corner(t, c));
    places[static_cast<std::size_t>(c)] = {p.x, p.y};
  }
  std::sort(places.begin(), places.end());
  return {places[0][0], places[0][1], places[1][0], places[1][1], places[2][0], places[2][1]};
}

std::set<LeftByRefine::Corners> LeftByRefine::triangles_of(const Mesh& mesh, const std::set<Corners>& among) const {
  std::set<Corners> found;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    const Corners corners = corners_of(mesh, t);
    if (among.contains(corners)) found.insert(corners);
  }
  return found;
}

void LeftByRefine::find_left() {
  if (is_known_) return;
  is_known_ = true;
  Mesh refined = before_;
  const Refined done = refine_copy(refined, goals_);
  is_settled_ = done == Refined::nothing;
  if (done == Refined::nothing) left_ = attacked_;
  if (done == Refined::some) left_ = triangles_of(refined, attacked_);
}

std::vector<LeftByRefine::Awakened> LeftByRefine::awakened_in(const Mesh& after) {
  find_left();
  std::vector<Awakened> awakened;
  if (left_.empty()) return awakened;
  Mesh refined = after;
  if (const Refined done = refine_copy(refined, goals_); done == Refined::nothing || done == Refined::too_much)
    return awakened;
  const std::set<Corners> still_there = triangles_of(refined, left_);
  for (const Corners& corners : triangles_of(after, left_)) {
    if (still_there.contains(corners)) continue;
    const Point a{corners[0], corners[1]}, b{corners[2], corners[3]}, c{corners[4], corners[5]};
    const Point center = circumcenter(a, b, c), middle = (1.0 / 3) * (a + b + c);
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    awakened.push_back({middle, is_finite(center) ? std::max(longest, distance(middle, center)) : longest});
  }
  if (!is_settled_) return awakened;  // it would have inserted points anyway: removals are not to blame
  const std::set<std::array<double, 2>> were = vertices_of(after);
  for (const HalfEdgeId h : refined.half_edges()) {
    if (!refined.is_alive(triangle_of(h))) continue;
    const Point &p = refined.point(refined.origin(h)), &q = refined.point(refined.target(h));
    if (!were.contains({p.x, p.y})) awakened.push_back({p, distance(p, q)});
  }
  return awakened;
}

}  // namespace pliant
