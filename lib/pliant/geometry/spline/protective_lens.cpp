// lib/pliant/geometry/spline/protective_lens.cpp: lenses seen from a point.
#include "pliant/geometry/spline/protective_lens.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace pliant {
namespace {

/// The points from which the chord a, b is seen under one angle form an arc; larger angles lie inside. `dot` and
/// `cross` of the two lines of sight tell the angle's cotangent without a division.
struct Sight {
  double dot, cross;
};
Sight sight(const Point& a, const Point& b, const Point& from) {
  return {dot(a - from, b - from), cross(a - from, b - from)};
}

// A lens of less than 30 degrees is refused: a control polygon that runs out beyond its ends would otherwise protect
// half a plane. Such a curve does not stay: it is split because of its turning.
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

  // Outside the circle, the lens reaches to the arc through the control point that sees the chord smallest, of those on
  // p's side; the hull, and so the curve, is inside. One subdivision hugs the curve more closely.
  const int side = at_p.cross > 0 ? 1 : -1;
  double cotangent = 0;
  for (const Point& b_i : halved(polygon)) {
    const Sight at = sight(a, b, b_i);
    if (at.cross * side > 0) cotangent = std::max(cotangent, at.dot / std::fabs(at.cross));
  }
  return at_p.dot < std::min(cotangent, most_cotangent) * std::fabs(at_p.cross);
}

}  // namespace pliant
