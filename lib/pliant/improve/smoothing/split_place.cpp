// lib/pliant/improve/smoothing/split_place.cpp: places by bisection along the curve, and what a split would turn over.
#include "pliant/improve/smoothing/split_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/predicates.h"
#include "pliant/mesh/star.h"
#include "pliant/mesh/turned_over.h"

namespace pliant {
namespace {

constexpr double balanced = 0.02;    // the middle of the parameter will do if the halves differ by at most this share
constexpr int most_place_steps = 8;  // steps of a place towards an end
constexpr double least_bend_of_gap = 0.25;  // two edges are split together if one bends by this share of their distance
constexpr double least_share = 0.1;  // a place on a shell leaves at least this share of the parameter on each side

Point point_on(std::span<const double> polygon, int degree, double s) {
  std::array<double, 2> value;
  evaluate_polygon(degree, 2, polygon, s, value);
  return {value[0], value[1]};
}

/// The s in (0, 1) at which `is_before(point)` changes from true to false.
template <class Predicate>
double bisect(std::span<const double> polygon, int degree, const Predicate& is_before) {
  double low = 0, high = 1;
  for (int i = 0; i < 53; ++i) {
    const double s = (low + high) / 2;
    (is_before(point_on(polygon, degree, s)) ? low : high) = s;
  }
  return (low + high) / 2;
}

/// A split at x makes two logical triangles on each side of the edge. Is the one on h's side, at the origin or else at
/// the target, turned over so that no flip of the edge behind it mends that?
bool turns_over(const Mesh& mesh, HalfEdgeId h, const Point& x, bool at_origin) {
  const Point &end = mesh.point(at_origin ? mesh.origin(h) : mesh.target(h)), &apex = mesh.point(mesh.apex(h));
  const int sign = at_origin ? 1 : -1;
  if (sign * orient2d(end, x, apex) > 0) return false;
  const HalfEdgeId behind = mesh.twin(at_origin ? previous(h) : next(h));
  if (behind == none || mesh.is_constrained(behind)) return true;
  const Point& beyond = mesh.point(mesh.apex(behind));
  return sign * orient2d(end, x, beyond) <= 0 || sign * orient2d(x, apex, beyond) <= 0;
}

/// The greatest distance of an edge's control points from the line through its chord.
double height_over_chord(const Mesh& mesh, HalfEdgeId h) {
  const Point& a = mesh.point(mesh.origin(h));
  const Vector along = mesh.point(mesh.target(h)) - a;
  double most = 0;
  for (int k = 1; k < mesh.degree(); ++k)
    most = std::max(most, std::fabs(cross(along, mesh.point(mesh.edge_point(h, k)) - a)));
  return most / length(along);
}

/// The control polygon of an edge as a flat array of coordinates.
struct Polygon {
  Polygon(const Mesh& mesh, HalfEdgeId h) : degree(mesh.degree()) {
    for (int k = 0; k <= degree; ++k) {
      const Point& b = mesh.point(mesh.edge_point(h, k));
      flat[index(2 * k)] = b.x, flat[index(2 * k + 1)] = b.y;
    }
  }
  std::span<const double> points() const { return {flat.data(), index(2 * (degree + 1))}; }

  int degree;
  std::array<double, 2 * (max_degree + 1)> flat;
};

/// The s in (0, 1) at which a curve is `radius` away from a point. Requires that it leads away from that or towards it.
double at_radius(std::span<const double> polygon, int degree, const Point& from, double radius) {
  const bool leads_away = distance(from, point_on(polygon, degree, 0)) < distance(from, point_on(polygon, degree, 1));
  return bisect(polygon, degree, [&](const Point& x) { return (distance(from, x) < radius) == leads_away; });
}

/// How far a point x is from that place of an edge which is as far from the corner as x.
double gap_at(const Mesh& mesh, HalfEdgeId h, const Point& corner, const Point& x) {
  const Polygon polygon(mesh, h);
  const double s = at_radius(polygon.points(), polygon.degree, corner, distance(corner, x));
  return distance(x, point_on(polygon.points(), polygon.degree, s));
}

/// The place on a shell if one end alone is a sharp corner, else the place as far from one end as from the other.
double balanced_place(const Mesh& mesh, HalfEdgeId h, const SharpCorners& corners, std::span<const double> polygon) {
  const int p = mesh.degree();
  const Point &a = mesh.point(mesh.origin(h)), &b = mesh.point(mesh.target(h));
  const bool is_corner[2] = {corners.contains(mesh.origin(h)), corners.contains(mesh.target(h))};
  if (is_corner[0] != is_corner[1]) {
    const Point& apex = is_corner[0] ? a : b;
    // The radii of shells are powers of two; this one lies between 1/3 and 2/3 of the chord.
    const double radius = std::exp2(std::floor(std::log2(distance(a, b) * (2.0 / 3))));
    const double s = at_radius(polygon, p, apex, radius);
    if (s > least_share && s < 1 - least_share) return s;
  }
  const auto unbalance = [&](const Point& x) { return distance(a, x) - distance(x, b); };
  if (std::fabs(unbalance(point_on(polygon, p, 0.5))) <= balanced * distance(a, b)) return 0.5;
  return bisect(polygon, p, [&](const Point& x) { return unbalance(x) < 0; });
}

}  // namespace

double split_place(const Mesh& mesh, HalfEdgeId h, const SharpCorners& corners) {
  const int p = mesh.degree();
  const Polygon all(mesh, h);
  const std::span<const double> polygon = all.points();
  // As far from the corner as the vertex on the other side, so that the two become neighbours. Exactly as far: where
  // curves bend by more than they are apart, only then are their chords in the order of the curves.
  if (const SharpCorners::Mirror mirror = corners.mirror(mesh, h); mirror.corner != none) {
    const double s = at_radius(polygon, p, mesh.point(mirror.corner), mirror.radius);
    if (s > least_share && s < 1 - least_share) return s;
  }
  const double place = balanced_place(mesh, h, corners, polygon);
  if (p == 1 || find_partner(mesh, h, corners, place)) return place;
  double s = place;
  for (int step = 0; step < most_place_steps; ++step) {
    const Point x = point_on(polygon, p, s);
    bool first = turns_over(mesh, h, x, true), second = turns_over(mesh, h, x, false);
    if (const HalfEdgeId g = mesh.twin(h); g != none) {
      first = first || turns_over(mesh, g, x, false);
      second = second || turns_over(mesh, g, x, true);
    }
    if (!first && !second) return s;
    if (first && second) break;
    s = first ? (s + 1) / 2 : s / 2;  // the chord to the far end leans less the nearer x is to the other
  }
  return place;
}

double place_at_radius(const Mesh& mesh, HalfEdgeId h, const Point& from, double radius) {
  const Polygon polygon(mesh, h);
  return at_radius(polygon.points(), polygon.degree, from, radius);
}

SplitPartner find_partner(const Mesh& mesh, HalfEdgeId h, const SharpCorners& corners, double s) {
  if (corners.empty() || mesh.degree() == 1) return {};
  const Polygon polygon(mesh, h);
  const Point x = point_on(polygon.points(), polygon.degree, s);
  Star star;
  for (const HalfEdgeId side : {h, mesh.twin(h)}) {
    if (side == none) continue;
    const PointId v = mesh.apex(side);
    for (const PointId end : {mesh.origin(h), mesh.target(h)}) {
      const PointId corner = corners.narrow_wedge(mesh, v, end, mesh.face(triangle_of(side)));
      if (corner == none) continue;
      const Point& apex = mesh.point(corner);
      const double radius = distance(apex, x);
      find_star(mesh, v, star);
      for (const HalfEdgeId out : star.outgoing)
        for (const HalfEdgeId beside : {out, previous(out)}) {
          if (!mesh.is_constrained(beside)) continue;
          const PointId a = mesh.origin(beside), b = mesh.target(beside);
          const auto [near, far] = std::minmax({distance(apex, mesh.point(a)), distance(apex, mesh.point(b))});
          const double margin = least_share * (far - near);
          if (radius < near + margin || radius > far - margin) continue;
          if (std::max(height_over_chord(mesh, h), height_over_chord(mesh, beside)) <
              least_bend_of_gap * gap_at(mesh, beside, apex, x))
            continue;
          return {a, b, corner};
        }
    }
  }
  return {};
}

HalfEdgeId curve_that_turns_over(const Mesh& mesh, TriangleId t) {
  constexpr double least_bend = 1e-3;  // in lengths of the chord: an edge that bends less turns nothing over
  if (!is_turned_over(mesh, t)) return none;
  std::vector<TriangleId> cluster{t};
  HalfEdgeId found = none;
  double most = 0;
  for (std::size_t k = 0; k < cluster.size() && k < 100; ++k)
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(cluster[k], e);
      if (mesh.is_constrained(h)) {
        const double bend = height_over_chord(mesh, h);
        const double chord = distance(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)));
        if (bend > std::max(most, least_bend * chord)) most = bend, found = h;
      } else if (is_turned_over(mesh, cluster[k])) {
        const TriangleId other = triangle_of(mesh.twin(h));
        if (std::find(cluster.begin(), cluster.end(), other) == cluster.end()) cluster.push_back(other);
      }
    }
  return found;
}

}  // namespace pliant
