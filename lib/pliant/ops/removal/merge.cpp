// lib/pliant/ops/removal/merge.cpp: ears flipped away in Devillers's order, and the triangles that are left joined.
#include "pliant/ops/removal/merge.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/flip_edge.h"

namespace pliant {

double depth_in_circle(const Point& a, const Point& b, const Point& c, const Point& v) {
  const Vector p = a - v, q = b - v, r = c - v;
  const double lifted =
      squared_length(p) * cross(q, r) + squared_length(q) * cross(r, p) + squared_length(r) * cross(p, q);
  return lifted / cross(b - a, c - a);
}

bool reduce_fan(Mesh& mesh, PointId v, Fan& fan, bool closed, int triangles, const RefitOptions& options) {
  thread_local std::vector<std::pair<double, int>> ears;
  for (;;) {
    const int count = static_cast<int>(fan.size()), left = closed ? count : count - 1;
    if (left <= triangles) return left == triangles;
    ears.clear();
    for (int i = closed ? 0 : 1; i < (closed ? count : count - 1); ++i) {
      const Point &a = mesh.point(fan[index((i + count - 1) % count)]), &b = mesh.point(fan[index(i)]),
                  &c = mesh.point(fan[index((i + 1) % count)]);
      if (cross(b - a, c - a) > 0) ears.emplace_back(depth_in_circle(a, b, c, mesh.point(v)), i);
    }
    std::sort(ears.begin(), ears.end());
    bool flipped = false;
    for (const auto& [depth, i] : ears) {
      const HalfEdgeId spoke = find_half_edge(mesh, v, fan[index(i)]);
      if (spoke == none || flip_edge(mesh, spoke, options) != Outcome::done) continue;
      fan.erase(fan.begin() + i);
      flipped = true;
      break;
    }
    if (!flipped) return false;
  }
}

bool recover_merged(const Mesh& mesh, PointId v, std::span<const PointId> fan, ParentRecovery& parent,
                    std::span<const Point> long_edge) {
  const int p = mesh.degree();
  const HalfEdgeId h0 = find_half_edge(mesh, v, fan[0]), h1 = find_half_edge(mesh, v, fan[1]);
  // Where v divides the long edge: as the tangents on either side of v are long.
  const HalfEdgeId back = previous(h1);  // fan[2] to v
  const double before = distance(mesh.point(mesh.edge_point(h0, 1)), mesh.point(v));
  const double after = distance(mesh.point(mesh.edge_point(back, p - 1)), mesh.point(v));
  if (!(before > 0 && after > 0)) return false;
  const double s = before / (before + after);  // from fan[0] to fan[2]
  const Barycentric on_edge{1 - s, 0, s};      // corners fan[0], fan[1], fan[2]
  const Barycentric q0{1, 0, 0}, q1{0, 1, 0}, q2{0, 0, 1};

  parent.start(mesh, std::array<TriangleId, 2>{triangle_of(h0), triangle_of(h1)});
  parent.take_edge(0, 0, edge_of(next(h0)));
  parent.take_edge(1, 1, edge_of(next(h1)));
  if (!parent.find_edge(2, 1 - s, {1, edge_of(back)}, {0, edge_of(h0)})) return false;
  if (!long_edge.empty()) parent.place_edge(2, long_edge);
  // The corners of a piece in its own order: v is local corner edge_of(h).
  const auto corners = [&](HalfEdgeId h, const Barycentric& origin, const Barycentric& target,
                           const Barycentric& apex) {
    std::array<Barycentric, 3> c;
    c[index(edge_of(h))] = origin;
    c[index((edge_of(h) + 1) % 3)] = target;
    c[index((edge_of(h) + 2) % 3)] = apex;
    return c;
  };
  return parent.find_inner(std::array{corners(h0, on_edge, q0, q1), corners(h1, on_edge, q1, q2)});
}

TriangleId merge_fan(Mesh& mesh, HalfEdgeId h, const EdgePoints& long_edge) {
  const HalfEdgeId h0 = h, h1 = mesh.twin(previous(h));
  const TriangleId kept = triangle_of(h0), dropped = triangle_of(h1);
  const Side near = side_of(mesh, next(h0)), far = side_of(mesh, next(h1));
  free_edge_points(mesh, side_of(mesh, h1).points);
  free_inner_points(mesh, inner_points(mesh, dropped));
  const InnerPoints inner = inner_points(mesh, kept);
  mesh.free_triangle(dropped);
  build_triangle(mesh, kept, near.points, far.points, long_edge, inner);
  attach(mesh, half_edge(kept, 0), near);
  attach(mesh, half_edge(kept, 1), far);
  mesh.link(half_edge(kept, 2), none);
  mesh.set_constraint(half_edge(kept, 2), none);
  return kept;
}

}  // namespace pliant
