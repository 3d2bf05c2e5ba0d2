// lib/pliant/geometry/spline/protective_lens.cpp: lenses as sets of points that see a chord under a large angle.
#include "pliant/geometry/spline/protective_lens.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace pliant {
namespace {

/// The lines of sight from a point to both ends of a chord: the cotangent of the angle between them is dot / |cross|.
/// The points that see the chord under one angle form an arc; points inside that arc see it under a larger angle.
struct Sight {
  double dot, cross;
};
Sight sight(const Point& a, const Point& b, const Point& from) {
  return {dot(a - from, b - from), cross(a - from, b - from)};
}

// cot 30 degrees: a point that sees the chord under a smaller angle is outside every lens. Otherwise a control polygon
// that runs out beyond its ends would protect half the plane. Such curves turn too much, and are split for that.
constexpr double most_cotangent = std::numbers::sqrt3;

/// One round of corner cutting at 1/2: the control polygons of both halves, as one.
std::vector<Point> halved(std::span<const Point> polygon) {
  std::vector<Point> row(polygon.begin(), polygon.end()), left, right;
  while (!row.empty()) {
    left.push_back(row.front());
    right.push_back(row.back());
    for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] = (row[i] + row[i + 1]) / 2;
    row.pop_back();
  }
  left.insert(left.end(), right.rbegin() + 1, right.rend());
  return left;
}

}  // namespace

bool is_encroached(std::span<const Point> polygon, const Point& p) {
  const Point& a = polygon.front();
  const Point& b = polygon.back();
  const Sight at_p = sight(a, b, p);
  if (at_p.dot < 0) return true;  // inside the diametral circle
  if (p == a || p == b || polygon.size() <= 2) return false;
  if (at_p.dot >= most_cotangent * std::fabs(at_p.cross)) return false;

  // Outside the circle the lens reaches, on p's side, to the arc through the control point that sees the chord under
  // the smallest angle. The hull, and so the curve, is inside that arc. The control points are those of both halves of
  // the curve, because these are nearer to it.
  const int side = at_p.cross > 0 ? 1 : -1;
  double cotangent = 0;
  for (const Point& b_i : halved(polygon)) {
    const Sight at = sight(a, b, b_i);
    if (at.cross * side > 0) cotangent = std::max(cotangent, at.dot / std::fabs(at.cross));
  }
  return at_p.dot < std::min(cotangent, most_cotangent) * std::fabs(at_p.cross);
}

}  // namespace pliant
