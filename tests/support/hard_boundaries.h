// tests/support/hard_boundaries.h: wings, gears and boxes of cells, on which meshing and refinement are tried.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/sample_boundaries.h"

namespace pliant::samples {

/// Adds a rectangle with the face inside.
inline void add_walls(BoundaryComplex& b, const Point& low, const Point& high, int face) {
  const int first = static_cast<int>(b.vertices.size());
  b.vertices.insert(b.vertices.end(), {low, {high.x, low.y}, high, {low.x, high.y}});
  for (int i = 0; i < 4; ++i) b.curves.push_back(open_curve(b, "wall", first + i, first + (i + 1) % 4, {}, face));
}

/// A gear with straight flanks and rounded edges, which a quadratic spline makes by cutting the corners of its polygon.
inline BoundaryComplex filleted_gear(int teeth, double fillet) {
  std::vector<Point> points;
  std::vector<Point> corners;
  for (int i = 0; i < 4 * teeth; ++i) {
    const double angle = 2 * std::numbers::pi * i / (4.0 * teeth), radius = i % 4 < 2 ? 1 : 0.85;
    corners.push_back(radius * Point{std::cos(angle), std::sin(angle)});
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    points.insert(points.end(), {a, (1 - fillet) * a + fillet * b, fillet * a + (1 - fillet) * b});
  }
  BoundaryComplex b = with_faces({"gear"});
  b.curves.push_back(closed_curve("outline", closed_spline(2, std::move(points)), 0));
  return b;
}

/// A cubic spline once around a profile of unit chord, from the trailing edge back to it; at(u), u from -1 to 1, is the
/// profile.
inline BSpline profile(Point (*at)(double), int count) {
  constexpr int degree = 3;
  std::vector<double> knots(degree, 0.0);
  for (int i = 0; i <= count - degree; ++i) knots.push_back(i);
  knots.insert(knots.end(), degree, count - degree);
  BSpline spline(degree, false, knots, std::vector<Point>(static_cast<std::size_t>(count)));
  std::vector<Point> values;
  for (const double t : spline.greville()) values.push_back(at(2 * t / (count - degree) - 1));
  if (!spline.interpolate(values)) throw std::runtime_error("the profile cannot be interpolated");
  spline.set_point(0, values.front());
  spline.set_point(count - 1, values.front());
  return spline;
}

/// The profile NACA 0012 with a closed trailing edge, whose angle is 2 atan(0.14) = 16 degrees. u^2 is the distance
/// from the leading edge along the chord, which makes the profile a smooth function of u.
inline Point naca_0012(double u) {
  const double x = u * u;
  return {x, -0.6 * (0.2969 * u + std::copysign(x, u) * (-0.126 + x * (-0.3516 + x * (0.2843 - 0.1036 * x))))};
}

/// The profile as a wing in air, inside a circle.
inline BoundaryComplex in_far_field(BSpline outline, double radius) {
  BoundaryComplex b = with_faces({"air", "wing"});
  b.vertices = {outline.points().front()};
  Curve curve = closed_curve("profile", std::move(outline), 1, 0);
  curve.start = curve.end = 0;
  b.curves.push_back(std::move(curve));
  b.curves.push_back(closed_curve("far field", circle(3, {}, radius, 16), 0));
  return b;
}

/// Round cells of radius 0.3 to 0.8 at random places in a box, no two of them closer to each other than `gap`.
inline BoundaryComplex cells_in_box(int count, double gap, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(0, 1);
  BoundaryComplex b = with_faces({"plasma"});
  const double side = std::sqrt(count * 3.2);
  add_walls(b, {0, 0}, {side, side}, 0);
  std::vector<std::pair<Point, double>> made;
  while (static_cast<int>(made.size()) < count) {
    const double radius = 0.3 + 0.5 * u(random), room = side - 2 * (radius + gap);
    const Point center{radius + gap + room * u(random), radius + gap + room * u(random)};
    const auto is_close = [&](const auto& other) {
      return distance(other.first, center) < other.second + radius + gap;
    };
    if (std::any_of(made.begin(), made.end(), is_close)) continue;
    made.emplace_back(center, radius);
    const int face = static_cast<int>(b.faces.size());
    b.faces.push_back({"cell " + std::to_string(face), {}});
    b.curves.push_back(closed_curve("", circle(2, center, radius), face, 0));
  }
  return b;
}

}  // namespace pliant::samples
