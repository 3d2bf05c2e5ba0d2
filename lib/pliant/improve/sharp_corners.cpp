#include "pliant/improve/sharp_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pliant {
namespace {

constexpr int most_steps = 64;  // along a curve towards a corner
constexpr FaceId several = -2;
constexpr double corner_reach = 1.95;  // lengths of a triangle within which a small angle excuses it
constexpr double most_extent = 3;      // of a triangle along a shell, in the shell's radius
constexpr double same_distance = 1.2;  // of two vertices from a corner

/// Direction in which the edge leaves its origin: the first leg of its control polygon that has a length.
Vector direction(const Mesh& mesh, HalfEdgeId h, bool reversed) {
  const int p = mesh.degree();
  const Point& origin = mesh.point(mesh.edge_point(h, reversed ? p : 0));
  for (int k = 1; k <= p; ++k) {
    const Point& b = mesh.point(mesh.edge_point(h, reversed ? p - k : k));
    if (!(b == origin)) return b - origin;
  }
  return {};
}

bool is_below_sixty(const Vector& a, const Vector& b) {
  return dot(a, b) > 0 && std::fabs(cross(a, b)) < std::numbers::sqrt3 * dot(a, b);
}

double logical_angle(const Mesh& mesh, HalfEdgeId h) {
  const Point& v = mesh.point(mesh.origin(h));
  const Vector a = mesh.point(mesh.target(h)) - v, b = mesh.point(mesh.apex(h)) - v;
  return std::atan2(cross(a, b), dot(a, b));
}

/// Do two edges on curves, next to each other, enclose a small angle here? Their tangents tell it, and the logical
/// triangles between them tell it from the rest of a full turn. The face, `several`, or outside if there is none.
FaceId sharp_face(const Mesh& mesh, const Star& star) {
  const std::size_t n = star.outgoing.size();
  FaceId face = outside;
  for (std::size_t i = 0; i < n; ++i) {
    if (!mesh.is_constrained(star.outgoing[i])) continue;
    const Vector from = direction(mesh, star.outgoing[i], false);
    double angle = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const HalfEdgeId h = star.outgoing[(i + k) % n];
      angle += logical_angle(mesh, h);
      if (angle > std::numbers::pi) break;
      const HalfEdgeId closing = previous(h);
      if (!mesh.is_constrained(closing)) continue;
      const FaceId here = mesh.face(triangle_of(h));
      if (is_below_sixty(from, direction(mesh, closing, true))) face = face == outside || face == here ? here : several;
      break;
    }
  }
  return face;
}

}  // namespace

SharpCorners::SharpCorners(const Mesh& mesh) {
  for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h) {
    if (!mesh.is_alive(triangle_of(h)) || !mesh.is_constrained(h)) continue;
    // A corner has two such edges in every face; the one that leaves it speaks for both.
    const PointId v = mesh.origin(h);
    if (contains(v)) continue;
    find_star(mesh, v, star_);
    if (const FaceId f = sharp_face(mesh, star_); f != outside) corners_.emplace(v, f);
  }
}

/// The corners that the curve through p leads to, if it is a vertex within a curve.
int SharpCorners::sides_from(const Mesh& mesh, PointId p, Side sides[2]) const {
  if (contains(p)) return 0;
  int count = 0;
  find_star(mesh, p, star_);
  PointId starts[2];
  int ways = 0;
  const auto collect = [&](PointId except, PointId out[2]) {
    int n = 0;
    const auto add = [&](PointId v) {
      if (v != except && n < 3) {
        if (n < 2) out[n] = v;
        ++n;
      }
    };
    for (const HalfEdgeId h : star_.outgoing)
      if (mesh.is_constrained(h)) add(mesh.target(h));
    if (!star_.is_closed && !star_.outgoing.empty() && mesh.is_constrained(previous(star_.outgoing.back())))
      add(mesh.apex(star_.outgoing.back()));
    return n;
  };
  ways = collect(none, starts);
  if (ways != 2) return 0;
  for (int k = 0; k < 2; ++k) {
    PointId before = p, v = starts[k];
    for (int step = 0; step < most_steps && !contains(v); ++step) {
      find_star(mesh, v, star_);
      PointId onward[2];
      if (collect(before, onward) != 1) {
        v = none;
        break;
      }
      before = v;
      v = onward[0];
    }
    if (v != none && contains(v)) sides[count++] = {v, before};
  }
  return count;
}

PointId SharpCorners::shared(const Mesh& mesh, PointId p, PointId q, FaceId f) const {
  if (corners_.empty()) return none;
  Side from_p[2], from_q[2];
  const int n = sides_from(mesh, p, from_p);
  const int m = n > 0 ? sides_from(mesh, q, from_q) : 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      if (from_p[i].corner == from_q[j].corner && from_p[i].first != from_q[j].first) {
        const FaceId face = corners_.at(from_p[i].corner);
        if (face == f || face == several) return from_p[i].corner;
      }
  return none;
}

bool SharpCorners::is_along_shell(const Mesh& mesh, HalfEdgeId h, double longest) const {
  const PointId p = mesh.origin(h), q = mesh.target(h);
  const PointId corner = shared(mesh, p, q, mesh.face(triangle_of(h)));
  if (corner == none) return false;
  const Point& apex = mesh.point(corner);
  const auto [near, far] = std::minmax({distance(apex, mesh.point(p)), distance(apex, mesh.point(q))});
  const double away = std::min(near, distance(apex, mesh.point(mesh.apex(h))));
  return far < same_distance * near && away <= corner_reach * longest && longest <= most_extent * near;
}

}  // namespace pliant
