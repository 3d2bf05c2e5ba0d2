// lib/pliant/flow/keep_cusps.cpp: finds the elements in cusps, and turns one tangent of each onto the other.
#include "pliant/flow/keep_cusps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pliant/geometry/predicates.h"
#include "pliant/mesh/check_mesh.h"

namespace pliant {
namespace {

constexpr double cusp_angle =
    1e-6;  // sides of a cusp that was kept differ by rounding, which counts for short tangents
constexpr int most_nudges = 20;

/// One end of a curve, with the control points that make its tangent there.
struct CurveEnd {
  CurveId curve;
  bool at_end;
  bool operator==(const CurveEnd&) const = default;

  int tip(const BSpline& spline) const { return at_end ? static_cast<int>(spline.points().size()) - 1 : 0; }
  int next(const BSpline& spline) const { return at_end ? tip(spline) - 1 : 1; }
  Point tip_point(const BSpline& spline) const { return spline.points()[static_cast<std::size_t>(tip(spline))]; }
  Point next_point(const BSpline& spline) const { return spline.points()[static_cast<std::size_t>(next(spline))]; }
};

/// The two sides of an element in a cusp, seen from the cusp.
struct Wedge {
  CurveEnd right, left;
};

Vector tangent(const CurveEnd& end, const BSpline& spline) { return end.next_point(spline) - end.tip_point(spline); }

bool is_cusp(const Mesh& mesh, const Wedge& wedge, const Point& corner) {
  const BSpline& right = mesh.spline(wedge.right.curve);
  const BSpline& left = mesh.spline(wedge.left.curve);
  if (right.closed() || left.closed() || right.degree() < 2) return false;
  if (wedge.right.tip_point(right) != corner || wedge.left.tip_point(left) != corner) return false;
  const Vector a = tangent(wedge.right, right), b = tangent(wedge.left, left);
  return dot(a, b) > 0 && std::abs(cross(a, b)) <= cusp_angle * dot(a, b);
}

/// The wedges at cusps, so that a wedge comes after the one on its right.
std::vector<Wedge> find_wedges(const Mesh& mesh) {
  std::vector<Wedge> wedges;
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    const int corner = cusp_corner(mesh.boundary(), net);
    if (corner == none) continue;
    const HalfEdgeId leaves = half_edge(t, corner), arrives = half_edge(t, (corner + 2) % 3);
    if (!mesh.is_constrained(leaves) || !mesh.is_constrained(arrives)) continue;
    const Wedge wedge{{mesh.constraint_curve(mesh.constraint(leaves)), !mesh.runs_forward(leaves)},
                      {mesh.constraint_curve(mesh.constraint(arrives)), mesh.runs_forward(arrives)}};
    if (is_cusp(mesh, wedge, net[static_cast<std::size_t>(corner)])) wedges.push_back(wedge);
  }
  for (std::size_t k = 0; k < wedges.size(); ++k) {
    const auto is_first = [&](const Wedge& one) {
      return std::none_of(wedges.begin() + static_cast<std::ptrdiff_t>(k), wedges.end(),
                          [&](const Wedge& other) { return other.left == one.right; });
    };
    const auto first = std::find_if(wedges.begin() + static_cast<std::ptrdiff_t>(k), wedges.end(), is_first);
    if (first != wedges.end()) std::iter_swap(wedges.begin() + static_cast<std::ptrdiff_t>(k), first);
  }
  return wedges;
}

bool is_at_rest(const CurveEnd& end, const BSpline& before, const BSpline& after) {
  return end.tip_point(before) == end.tip_point(after) && end.next_point(before) == end.next_point(after);
}

/// Turns the tangent of `turned` onto that of `kept`; `side` is 1 where it must not come to lie to the right of it, -1
/// for the left.
void turn_onto(const CurveEnd& kept, const CurveEnd& turned, int side, std::vector<BSpline>& splines) {
  const BSpline& still = splines[static_cast<std::size_t>(kept.curve)];
  BSpline& spline = splines[static_cast<std::size_t>(turned.curve)];
  const Vector along = tangent(kept, still);
  const double length = std::hypot(along.x, along.y);
  const Vector old = tangent(turned, spline);
  if (!(length > 0)) return;
  const Point tip = kept.tip_point(still), ahead = kept.next_point(still);
  const Vector normal = side / length * Vector{-along.y, along.x};
  const Point target = tip + std::hypot(old.x, old.y) / length * along;
  const double bit = std::numeric_limits<double>::epsilon() *
                     std::max({std::abs(target.x), std::abs(target.y), std::abs(tip.x), std::abs(tip.y)});
  Point place = target;
  for (int k = 0; k < most_nudges && side * orient2d(tip, ahead, place) < 0; ++k)
    place = target + std::ldexp(0.5 * bit, k) * normal;
  spline.set_point(turned.next(spline), place);
}

}  // namespace

void keep_cusps(const Mesh& mesh, MovedBoundary& boundary) {
  if (mesh.boundary().cusps.empty()) return;
  for (const Wedge& wedge : find_wedges(mesh)) {
    const auto rests = [&](const CurveEnd& end) {
      return is_at_rest(end, mesh.spline(end.curve), boundary.splines[static_cast<std::size_t>(end.curve)]);
    };
    if (rests(wedge.left)) {
      if (!rests(wedge.right)) turn_onto(wedge.left, wedge.right, -1, boundary.splines);
    } else {
      turn_onto(wedge.right, wedge.left, 1, boundary.splines);
    }
  }
}

}  // namespace pliant
