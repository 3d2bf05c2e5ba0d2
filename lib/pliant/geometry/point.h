// lib/pliant/geometry/point.h: locations and vectors in the plane, barycentric coordinates, boxes.
#pragma once
#include <array>
#include <cmath>

namespace pliant {

/// A location in the plane, or a difference of two (the same two doubles; `Vector` says which is meant).
struct Point {
  double x = 0;
  double y = 0;
  friend constexpr bool operator==(const Point&, const Point&) = default;
  constexpr Point& operator+=(const Point& b) { return x += b.x, y += b.y, *this; }
  constexpr Point& operator-=(const Point& b) { return x -= b.x, y -= b.y, *this; }
  constexpr Point& operator*=(double s) { return x *= s, y *= s, *this; }
};
using Vector = Point;

constexpr Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
constexpr Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
constexpr Point operator-(const Point& a) { return {-a.x, -a.y}; }
constexpr Point operator*(double s, const Point& a) { return {s * a.x, s * a.y}; }
constexpr Point operator*(const Point& a, double s) { return {s * a.x, s * a.y}; }
constexpr Point operator/(const Point& a, double s) { return {a.x / s, a.y / s}; }
constexpr double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
constexpr double squared_length(const Vector& a) { return dot(a, a); }
inline double length(const Vector& a) { return std::hypot(a.x, a.y); }
inline double distance(const Point& a, const Point& b) { return length(b - a); }
inline bool is_finite(const Point& a) { return std::isfinite(a.x) && std::isfinite(a.y); }
/// The vector turned by a quarter counter-clockwise.
constexpr Vector perpendicular(const Vector& a) { return {-a.y, a.x}; }

/// Barycentric coordinates (xi1, xi2, xi3) in a triangle; they sum to 1.
using Barycentric = std::array<double, 3>;

/// An axis-parallel box; empty until it is extended.
struct Box {
  Point low{HUGE_VAL, HUGE_VAL};
  Point high{-HUGE_VAL, -HUGE_VAL};
  void extend(const Point& p) {
    if (p.x < low.x) low.x = p.x;
    if (p.y < low.y) low.y = p.y;
    if (p.x > high.x) high.x = p.x;
    if (p.y > high.y) high.y = p.y;
  }
  bool contains(const Point& p) const { return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y; }
  bool overlaps(const Box& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y;
  }
  /// The length of the diagonal; 0 for an empty box. The *size* of a mesh is that of the box of all its control points.
  double size() const { return low.x <= high.x ? distance(low, high) : 0; }
  /// The largest |coordinate|, which decides what a unit in the last place is; 0 for an empty box.
  double reach() const {
    if (!(low.x <= high.x)) return 0;
    return std::fmax(std::fmax(-low.x, high.x), std::fmax(-low.y, high.y));
  }
  /// How far apart two computations of the same place in the box may be: 1e-12 of the box's size, or, if the box is far
  /// from the origin, 16 units in the last place of its largest coordinate.
  double tolerance() const { return std::fmax(1e-12 * size(), 0x1p-48 * reach()); }
};

}  // namespace pliant
