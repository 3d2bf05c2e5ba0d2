// tests/boundary/painted_faces.h: faces to be arranged, and which of them is visible at a point.
#pragma once
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "pliant/boundary/arrangement.h"
#include "pliant/boundary/check_boundary.h"
#include "pliant/boundary/curve_intersections.h"
#include "pliant/boundary/curve_points.h"
#include "support/sample_boundaries.h"

namespace pliant::samples {

/// A closed polygon as a curve of any degree.
inline BSpline polygon(int degree, std::vector<Point> points) {
  std::rotate(points.begin(), points.begin() + 1,
              points.end());  // a curve of degree 1 begins in its last control point
  BSpline spline = closed_spline(1, std::move(points));
  while (spline.degree() < degree) spline = spline.elevated();
  return spline;
}
inline BSpline rectangle(int degree, const Point& low, const Point& high) {
  return polygon(degree, {low, {high.x, low.y}, high, {low.x, high.y}});
}

inline FilledFace filled(std::string name, std::vector<BSpline> curves, FillRule rule = FillRule::nonzero) {
  return {std::move(name), std::move(curves), rule, {}};
}

/// How often a curve winds around p, which is not on it, by the crossings of a ray.
inline int winding(const BSpline& spline, const Point& p) {
  int turns = 0;
  std::vector<Point> bezier(static_cast<std::size_t>(spline.degree()) + 1), part(bezier.size());
  const auto breaks = spline.breaks();
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
    spline.extract(breaks[s], bezier);
    std::vector<double> cuts = monotone_cuts(bezier, 1e-12);
    cuts.push_back(1);
    double from = 0;
    Point start = bezier.front();
    for (const double to : cuts) {
      const Point end = to == 1 ? bezier.back() : bezier_point(bezier, to);
      if ((start.y > p.y) != (end.y > p.y)) {
        double low = from, high = to;
        for (int i = 0; i < 60; ++i) {
          const double middle = low + (high - low) / 2;
          ((bezier_point(bezier, middle).y > p.y) == (start.y > p.y) ? low : high) = middle;
        }
        if (bezier_point(bezier, low).x > p.x) turns += end.y > p.y ? 1 : -1;
      }
      from = to;
      start = end;
    }
  }
  return turns;
}

/// The input face that is visible at p if faces are painted one over the other.
inline int painted(const std::vector<FilledFace>& faces, const Point& p) {
  int owner = outside;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    int turns = 0;
    for (const BSpline& spline : faces[f].curves) turns += winding(spline, p);
    if (faces[f].rule == FillRule::nonzero ? turns != 0 : turns % 2 != 0) owner = static_cast<int>(f);
  }
  return owner;
}

/// The input face of the arrangement's face that contains p; checks that no two do.
inline int found_at(const Arrangement& a, const Point& p) {
  std::vector<int> turns(a.boundary.faces.size(), 0);
  for (const Curve& curve : a.boundary.curves) {
    const int w = winding(curve.spline, p);
    if (curve.left != outside) turns[static_cast<std::size_t>(curve.left)] += w;
    if (curve.right != outside) turns[static_cast<std::size_t>(curve.right)] -= w;
  }
  int owner = outside;
  for (std::size_t f = 0; f < turns.size(); ++f) {
    if (turns[f] == 0) continue;
    CHECK(turns[f] == 1);
    CHECK(owner == outside);
    owner = a.sources[f];
  }
  return owner;
}

inline double area_of(const BoundaryComplex& boundary, int face) {
  double area = 0;
  for (const Curve& curve : boundary.curves)
    area += ((curve.left == face) - (curve.right == face)) * curve.spline.area();
  return area;
}

inline std::string first_text(const std::vector<Fault>& faults) {
  return faults.empty() ? "" : faults.front().place + ": " + faults.front().text;
}

inline bool same(const BoundaryComplex& a, const BoundaryComplex& b) {
  const auto same_curve = [](const Curve& x, const Curve& y) {
    return x.name == y.name && x.start == y.start && x.end == y.end && x.left == y.left && x.right == y.right &&
           x.spline.knots() == y.spline.knots() && x.spline.points() == y.spline.points() &&
           x.spline.closed() == y.spline.closed();
  };
  return a.vertices == b.vertices && a.faces.size() == b.faces.size() &&
         std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(), same_curve);
}

/// Checks that painting and the arrangement give the same face at many points that lie on no curve.
inline void check_membership(const std::vector<FilledFace>& faces, const Arrangement& a, int count, unsigned seed) {
  Box box;
  for (const FilledFace& face : faces)
    for (const BSpline& spline : face.curves)
      for (const Point& p : spline.points()) box.extend(p);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(box.low.x, box.high.x), y(box.low.y, box.high.y);
  int differ = 0;
  for (int i = 0; i < count; ++i) {
    const Point p{x(random), y(random)};
    differ += painted(faces, p) != found_at(a, p);
  }
  CHECK(differ == 0);
}

inline void check_arranged(const std::vector<FilledFace>& faces, const Arrangement& a, int count = 300,
                           unsigned seed = 1) {
  REQUIRE(first_text(a.faults) == "");
  REQUIRE(first_text(check_boundary(a.boundary)) == "");
  CHECK(first_text(check_boundary_geometry(a.boundary)) == "");
  check_membership(faces, a, count, seed);
  const Arrangement again = resolve(a.boundary);
  CHECK(first_text(again.faults) == "");
  CHECK(same(again.boundary, a.boundary));
}

}  // namespace pliant::samples
