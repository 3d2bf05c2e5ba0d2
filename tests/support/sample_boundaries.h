// tests/support/sample_boundaries.h: boundary complexes of many kinds, of any degree.
#pragma once
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "pliant/boundary/boundary_complex.h"

namespace pliant::samples {

/// A closed uniform B-spline with these control points.
inline BSpline closed_spline(int degree, std::vector<Point> points) {
  std::vector<double> knots;
  for (std::size_t i = 0; i <= points.size(); ++i) knots.push_back(static_cast<double>(i));
  return BSpline(degree, true, std::move(knots), std::move(points));
}

/// A closed B-spline whose control points lie on a curve given in polar coordinates.
inline BSpline polar_spline(int degree, int count, const Point& center, const std::function<double(double)>& radius) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.push_back(center + radius(angle) * Point{std::cos(angle), std::sin(angle)});
  }
  return closed_spline(degree, std::move(points));
}

inline BSpline circle(int degree, const Point& center, double radius, int count = 8) {
  return polar_spline(degree, count, center, [radius](double) { return radius; });
}

/// One Bézier curve as an open B-spline.
inline BSpline bezier(std::vector<Point> points) {
  const std::size_t p = points.size() - 1;
  std::vector<double> knots(p + 1, 0.0);
  knots.insert(knots.end(), p + 1, 1.0);
  return BSpline(static_cast<int>(p), false, std::move(knots), std::move(points));
}

inline Curve closed_curve(std::string name, BSpline spline, int left, int right = outside) {
  Curve curve;
  curve.name = std::move(name);
  curve.spline = std::move(spline);
  curve.left = left;
  curve.right = right;
  return curve;
}

/// An open curve between two vertices of the boundary, with inner control points as given (none: straight).
inline Curve open_curve(const BoundaryComplex& boundary, std::string name, int start, int end,
                        const std::vector<Point>& inner, int left, int right = outside) {
  std::vector<Point> points{boundary.vertices[static_cast<std::size_t>(start)]};
  points.insert(points.end(), inner.begin(), inner.end());
  points.push_back(boundary.vertices[static_cast<std::size_t>(end)]);
  Curve curve = closed_curve(std::move(name), bezier(std::move(points)), left, right);
  curve.start = start;
  curve.end = end;
  return curve;
}

inline BoundaryComplex with_faces(const std::vector<std::string>& names) {
  BoundaryComplex boundary;
  for (const std::string& name : names) boundary.faces.push_back({name, {}});
  return boundary;
}

inline BoundaryComplex one_cell(int degree) {
  BoundaryComplex b = with_faces({"cell"});
  b.curves.push_back(closed_curve("membrane", circle(degree, {0.3, -0.2}, 1), 0));
  return b;
}

/// A red blood cell's section: a closed curve that is concave on two sides.
inline BoundaryComplex biconcave_cell(int degree) {
  BoundaryComplex b = with_faces({"cell"});
  b.curves.push_back(closed_curve(
      "membrane", polar_spline(degree, 24, {}, [](double a) { return 1 - 0.62 * std::sin(a) * std::sin(a); }), 0));
  return b;
}

inline BoundaryComplex three_cells(int degree) {
  BoundaryComplex b = with_faces({"near", "upper", "lower"});
  for (int i = 0; i < 3; ++i)
    b.curves.push_back(
        closed_curve("membrane " + std::to_string(i), circle(degree, {-1.0 * i, 2.5 * i}, 0.8, 8 + i), i));
  return b;
}

inline BoundaryComplex annulus(int degree, double inner = 0.7) {
  BoundaryComplex b = with_faces({"ring"});
  b.curves.push_back(closed_curve("outer", circle(degree, {}, 1, 9), 0));
  b.curves.push_back(closed_curve("hole", circle(degree, {}, inner, 7), outside, 0));
  return b;
}

/// A straight channel around two cells.
inline BoundaryComplex interface(int degree) {
  BoundaryComplex b = with_faces({"plasma", "cell", "other"});
  b.vertices = {{0, 0}, {4, 0}, {4, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) b.curves.push_back(open_curve(b, "wall " + std::to_string(i), i, (i + 1) % 4, {}, 0));
  b.curves.push_back(closed_curve("membrane", circle(degree, {1, 0.5}, 0.45), 1, 0));
  b.curves.push_back(closed_curve("second", circle(degree, {2.5, 0.5}, 0.3, 5), 2, 0));
  return b;
}

inline BoundaryComplex square() {
  BoundaryComplex b = with_faces({"square"});
  b.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) b.curves.push_back(open_curve(b, "side " + std::to_string(i), i, (i + 1) % 4, {}, 0));
  return b;
}

/// A square whose sides bulge, two inwards and two outwards; a curve through the middle makes two faces of it.
inline BoundaryComplex divided_square() {
  BoundaryComplex b = with_faces({"below", "above"});
  b.vertices = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {2, 1}, {0, 1}};
  b.curves.push_back(open_curve(b, "floor", 0, 1, {{1, 0.8}}, 0));
  b.curves.push_back(open_curve(b, "right low", 1, 4, {}, 0));
  b.curves.push_back(open_curve(b, "middle", 4, 5, {{1.5, 0.6}}, 0, 1));
  b.curves.push_back(open_curve(b, "left low", 5, 0, {}, 0));
  b.curves.push_back(open_curve(b, "right high", 4, 2, {{2.3, 1.6}}, 1));
  b.curves.push_back(open_curve(b, "top", 2, 3, {{1, 3}}, 1));
  b.curves.push_back(open_curve(b, "left high", 3, 5, {}, 1));
  return b;
}

/// A polygon with many teeth, as one closed curve with corners.
inline BoundaryComplex gear(int teeth = 24) {
  std::vector<Point> points;
  for (int i = 0; i < 4 * teeth; ++i) {
    const double angle = 2 * std::numbers::pi * i / (4.0 * teeth), radius = i % 4 < 2 ? 1 : 0.85;
    points.push_back(radius * Point{std::cos(angle), std::sin(angle)});
  }
  BoundaryComplex b = with_faces({"gear"});
  b.curves.push_back(closed_curve("outline", closed_spline(1, std::move(points)), 0));
  return b;
}

/// The outline of a letter with a hole: quadratic curves and lines, joined smoothly and in sharp corners (double
/// knots).
inline BoundaryComplex glyph() {
  BoundaryComplex b = with_faces({"e"});
  const std::vector<Point> outline{{1.0, 0.55}, {0.25, 0.55}, {0.27, 0.15}, {0.6, 0.15},  {0.78, 0.15}, {0.97, 0.25},
                                   {0.97, 0.1}, {0.78, 0.0},  {0.58, 0.0},  {0.33, 0.0},  {0.0, 0.25},  {0.0, 0.5},
                                   {0.0, 0.76}, {0.3, 1.05},  {0.53, 1.05}, {0.75, 1.05}, {1.0, 0.8},   {1.0, 0.6}};
  // Points 0, 2, 4, ... are on the curve, the others its quadratic control points: every break is a double knot.
  std::vector<double> knots{0};
  const std::size_t spans = outline.size() / 2;
  for (std::size_t i = 1; i <= spans; ++i) knots.insert(knots.end(), 2, static_cast<double>(i));
  // Basis function i starts at knot i, and the first break has its second knot at the end of the period.
  std::vector<Point> rotated(outline.begin() + 1, outline.end());
  rotated.push_back(outline.front());
  std::rotate(rotated.begin(), rotated.end() - 1, rotated.end());
  b.curves.push_back(closed_curve("outline", BSpline(2, true, knots, rotated), outside, 0));
  const BSpline counter = circle(2, {0.54, 0.78}, 0.16, 6);
  b.curves.push_back(closed_curve("counter", counter, outside, 0));
  return b;
}

/// A crescent: two arcs that meet in two vertices with a small angle, or a cusp (height 0) at the first of them.
inline BoundaryComplex crescent(double height) {
  BoundaryComplex b = with_faces({"moon"});
  b.vertices = {{0, 0}, {2, 0}};
  b.curves.push_back(open_curve(b, "lower", 0, 1, {{0.5, 0}, {1.2, 0.2}}, 0));
  b.curves.push_back(open_curve(b, "upper", 1, 0, {{1.6, 1.5}, {0.5, height}}, 0));
  return b;
}

}  // namespace pliant::samples
