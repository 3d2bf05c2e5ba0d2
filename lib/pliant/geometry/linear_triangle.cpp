// lib/pliant/geometry/linear_triangle.cpp: measures of straight triangles.
#include "pliant/geometry/linear_triangle.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace pliant {

double triangle_area(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a) / 2; }

Point circumcenter(const Point& a, const Point& b, const Point& c) {
  const Vector u = b - a, v = c - a;
  const Vector offset = squared_length(u) * perpendicular(v) - squared_length(v) * perpendicular(u);
  return a - offset / (2 * cross(u, v));
}

double triangle_shape(const Point& a, const Point& b, const Point& c) {
  const double squares = squared_length(b - a) + squared_length(c - b) + squared_length(a - c);
  return squares > 0 ? 4 * std::numbers::sqrt3 * triangle_area(a, b, c) / squares : 0;
}

double least_angle(const Point& a, const Point& b, const Point& c) {
  // The least angle is opposite the shortest side.
  const double ab = squared_length(b - a), bc = squared_length(c - b), ca = squared_length(a - c);
  const auto angle = [](const Point& at, const Point& p, const Point& q) {
    return std::atan2(std::fabs(cross(p - at, q - at)), dot(p - at, q - at));
  };
  if (ab <= bc && ab <= ca) return angle(c, a, b);
  return bc <= ca ? angle(a, b, c) : angle(b, c, a);
}

double radius_edge_ratio(const Point& a, const Point& b, const Point& c) {
  const double ab = distance(a, b), bc = distance(b, c), ca = distance(c, a);
  const double area = std::fabs(triangle_area(a, b, c));
  if (area == 0) return std::numeric_limits<double>::infinity();
  return ab * bc * ca / (4 * area) / std::min({ab, bc, ca});
}

Barycentric barycentric(const Point& a, const Point& b, const Point& c, const Point& p) {
  const double whole = cross(b - a, c - a);
  const double second = cross(p - a, c - a) / whole, third = cross(b - a, p - a) / whole;
  return {1 - second - third, second, third};
}

}  // namespace pliant
