// lib/pliant/boundary/hull_separation.cpp: are two control polygons' convex hulls apart?
#include "pliant/boundary/hull_separation.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

/// Whether a line with this normal separates the polygons by more than `margin`.
bool separates(const Vector& normal, std::span<const Point> a, std::span<const Point> b, double margin) {
  const double scale = length(normal);
  if (!(scale > 0)) return false;
  double low_a = HUGE_VAL, high_a = -HUGE_VAL, low_b = HUGE_VAL, high_b = -HUGE_VAL;
  const Point origin = a.front();  // relative to the true origin, far away, rounding would exceed the difference
  for (const Point& p : a) {
    const double s = dot(normal, p - origin);
    low_a = std::min(low_a, s);
    high_a = std::max(high_a, s);
  }
  for (const Point& p : b) {
    const double s = dot(normal, p - origin);
    low_b = std::min(low_b, s);
    high_b = std::max(high_b, s);
  }
  return low_a - high_b > margin * scale || low_b - high_a > margin * scale;
}

bool own_normals_separate(std::span<const Point> a, std::span<const Point> b, double margin) {
  if (separates(perpendicular(a.back() - a.front()), a, b, margin)) return true;
  for (std::size_t i = 1; i < a.size(); ++i)
    if (separates(perpendicular(a[i] - a[i - 1]), a, b, margin)) return true;
  return false;
}

}  // namespace

bool hulls_apart(std::span<const Point> a, std::span<const Point> b, double margin) {
  return separates({1, 0}, a, b, margin) || separates({0, 1}, a, b, margin) || own_normals_separate(a, b, margin) ||
         own_normals_separate(b, a, margin) || separates(a.back() - a.front(), a, b, margin) ||
         separates(b.back() - b.front(), a, b, margin);
}

bool cones_apart(std::span<const Point> a, std::span<const Point> b, double margin) {
  const Point apex = a.front();
  Vector along_a = a.back() - apex, along_b = b.back() - apex;
  const double length_a = length(along_a), length_b = length(along_b);
  if (!(length_a > 0) || !(length_b > 0)) return false;
  along_a = along_a / length_a;
  along_b = along_b / length_b;
  // The normal of the line is normal to the bisector of both directions. Where they are nearly opposite, rounding
  // leaves nothing of the bisector, which is their sum; but their difference has the same direction as its normal.
  Vector normal = dot(along_a, along_b) > 0 ? perpendicular(along_a + along_b) : along_a - along_b;
  if (dot(normal, along_a) < dot(normal, along_b)) normal = -normal;
  const double scale = length(normal);
  const auto on_side = [&](std::span<const Point> polygon, double sign) {
    return std::all_of(polygon.begin() + 1, polygon.end(), [&](const Point& p) {
      return sign * dot(normal, p - apex) > margin * scale * length(p - apex);
    });
  };
  return on_side(a, 1) && on_side(b, -1);
}

double hull_height(std::span<const Point> polygon) {
  const Vector chord = polygon.back() - polygon.front();
  const double scale = length(chord);
  double height = 0;
  for (const Point& p : polygon) {
    const Vector d = p - polygon.front();
    height = std::max(height, scale > 0 ? std::fabs(cross(chord, d)) / scale : length(d));
  }
  return height;
}

}  // namespace pliant
