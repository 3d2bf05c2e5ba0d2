// lib/pliant/improve/refining/insertion_search.cpp: a walk to a point, its Delaunay cavity, and the lenses at the
// border.
#include "pliant/improve/refining/insertion_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/geometry/predicates.h"
#include "pliant/geometry/spline/protective_lens.h"

namespace pliant {
namespace {

constexpr std::size_t most_cavity = 200;  // triangles of a cavity that are looked at
constexpr double near_edge = 1e-3;  // a point this near an edge, in distances to the nearest corner, splits the edge

}  // namespace

HalfEdgeId InsertionSearch::walk_to(TriangleId t, const Point& p) {
  const Point start =
      (1.0 / 3) * (mesh_.point(mesh_.corner(t, 0)) + mesh_.point(mesh_.corner(t, 1)) + mesh_.point(mesh_.corner(t, 2)));
  reached_ = t;
  HalfEdgeId entered = none;
  for (long step = 0; step < 10 + 2L * mesh_.triangle_count(); ++step) {
    HalfEdgeId leave = none;
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(reached_, e);
      const Point &a = mesh_.point(mesh_.origin(h)), &b = mesh_.point(mesh_.target(h));
      if (h == entered || orient2d(a, b, p) >= 0) continue;
      if (orient2d(start, p, a) <= 0 && orient2d(start, p, b) >= 0) leave = h;  // the segment leaves through it
      if (leave == none) leave = h;
    }
    if (leave == none) return none;
    if (mesh_.is_constrained(leave) || mesh_.twin(leave) == none) return leave;
    entered = mesh_.twin(leave);
    reached_ = triangle_of(entered);
  }
  return none;
}

HalfEdgeId InsertionSearch::find_encroached(TriangleId from, const Point& p) {
  cavity_.assign(1, from);
  HalfEdgeId found = none;
  double nearest = HUGE_VAL;
  for (std::size_t k = 0; k < cavity_.size() && k < most_cavity; ++k)
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(cavity_[k], e), g = mesh_.twin(h);
      if (mesh_.is_constrained(h) || g == none) {
        std::array<Point, max_degree + 1> polygon;
        mesh_.gather_edge_points(h, polygon);
        if (!is_encroached({polygon.data(), index(mesh_.degree() + 1)}, p)) continue;
        const double far = distance(0.5 * (polygon[0] + polygon[index(mesh_.degree())]), p);
        if (far < nearest) nearest = far, found = h;
        continue;
      }
      const TriangleId other = triangle_of(g);
      if (std::find(cavity_.begin(), cavity_.end(), other) != cavity_.end()) continue;
      if (in_circle(mesh_.point(mesh_.corner(other, 0)), mesh_.point(mesh_.corner(other, 1)),
                    mesh_.point(mesh_.corner(other, 2)), p) > 0)
        cavity_.push_back(other);
    }
  return found;
}

double InsertionSearch::edge_tolerance(TriangleId k, const Barycentric& xi, double nearest) const {
  const auto c = static_cast<int>(std::min_element(xi.begin(), xi.end()) - xi.begin());
  const double least = std::max(0.0, xi[index(c)]);
  const Point &a = mesh_.point(mesh_.corner(k, c)), &b = mesh_.point(mesh_.corner(k, (c + 1) % 3)),
              &d = mesh_.point(mesh_.corner(k, (c + 2) % 3));
  const double height = std::fabs(cross(b - a, d - a)) / distance(b, d);
  return least * height < near_edge * nearest ? std::nextafter(least, 1.0) : std::min(least, near_edge);
}

double distance_from_chord(const Mesh& mesh, HalfEdgeId h, PointId v) {
  const Point& a = mesh.point(mesh.origin(h));
  const Vector along = mesh.point(mesh.target(h)) - a, off = mesh.point(v) - a;
  const double s = std::clamp(dot(off, along) / squared_length(along), 0.0, 1.0);
  return length(off - s * along);
}

double gap_over(const Mesh& mesh, HalfEdgeId h) {
  double least = HUGE_VAL;
  for (const HalfEdgeId side : {h, mesh.twin(h)})
    if (side != none) least = std::min(least, distance_from_chord(mesh, h, mesh.apex(side)));
  return least;
}

}  // namespace pliant
