// tests/boundary/curve_intersections_test.cpp: Bézier curves meet, or touch, where formulas say that they do.
#include "pliant/boundary/curve_intersections.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "pliant/boundary/curve_points.h"

using namespace pliant;

namespace {

constexpr double tolerance = 1e-11;

std::vector<Point> places(std::span<const Point> a, std::span<const Point> b, const CommonEnds& common = {}) {
  std::vector<Point> found;
  for (const Meeting& m : find_meetings(a, b, common, tolerance)) {
    const Point p = bezier_point(a, m.s);
    CHECK(distance(p, bezier_point(b, m.t)) <= 3 * tolerance);
    if (std::none_of(found.begin(), found.end(), [&](const Point& q) { return distance(p, q) < 10 * tolerance; }))
      found.push_back(p);
  }
  return found;
}

}  // namespace

TEST_CASE("cuts leave pieces that are monotone in x and in y", "[boundary][property]") {
  const int degree = GENERATE(1, 2, 3, 5, 8);
  std::mt19937 random(static_cast<unsigned>(degree));
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int run = 0; run < 200; ++run) {
    std::vector<Point> curve;
    for (int i = 0; i <= degree; ++i) curve.push_back({coordinate(random), coordinate(random)});
    std::vector<double> cuts = monotone_cuts(curve, 1e-11);
    CHECK(static_cast<int>(cuts.size()) <= 2 * (degree - 1));
    cuts.insert(cuts.begin(), 0);
    cuts.push_back(1);
    for (std::size_t c = 1; c < cuts.size(); ++c) {
      Point last = bezier_point(curve, cuts[c - 1]);
      const Vector way = bezier_point(curve, cuts[c]) - last;
      for (int i = 1; i <= 20; ++i) {
        const Point p = bezier_point(curve, cuts[c - 1] + (cuts[c] - cuts[c - 1]) * i / 20);
        CHECK((p.x - last.x) * way.x >= -1e-14);
        CHECK((p.y - last.y) * way.y >= -1e-14);
        last = p;
      }
    }
  }
}

TEST_CASE("a parabola and a line meet where the quadratic formula says", "[boundary]") {
  // y = x^2 on [0, 1] and y = x / 2 + 1 / 8 - h, of which the roots are 1/4 + sqrt(3/16 - h) and another one below 0.
  const std::vector<Point> parabola{{0, 0}, {0.5, 0}, {1, 1}};
  for (const double h : {0.0, 0.01, 0.1, 0.12}) {
    const std::vector<Point> line{{0, 0.125 - h}, {2, 1.125 - h}};
    const double x = 0.25 + std::sqrt(3.0 / 16 - h);
    const auto found = places(parabola, line);
    REQUIRE(found.size() == 1);
    CHECK(distance(found[0], {x, x * x}) < 1e-15);
  }
}

TEST_CASE("curves that touch meet along a short stretch, and curves that just miss do not meet", "[boundary]") {
  const std::vector<Point> parabola{{0, 0}, {0.5, 0}, {1, 1}};
  for (const double gap : {-1e-13, 0.0, 1e-13}) {
    const std::vector<Point> tangent{{0, -0.25 - gap}, {1, 0.75 - gap}};  // touches in (1/2, 1/4)
    const auto found = places(parabola, tangent);
    REQUIRE(!found.empty());
    for (const Point& p : found) CHECK(distance(p, {0.5, 0.25}) < 1e-5);
  }
  CHECK(places(parabola, std::vector<Point>{{0, -0.25 - 1e-10}, {1, 0.75 - 1e-10}}).empty());
  CHECK(places(parabola, std::vector<Point>{{0, -0.25 + 1e-10}, {1, 0.75 + 1e-10}}).size() == 2);
}

TEST_CASE("overlapping parts of one curve meet in the ends of the part that they share", "[boundary]") {
  const std::vector<Point> curve{{0, 0}, {0.1, 0.7}, {0.4, 0.9}, {1, 1}};
  std::vector<Point> a(4), b(4);
  bezier_part(curve, 0, 0.7, a);
  bezier_part(curve, 1, 0.2, b);
  const auto found = places(a, b);
  REQUIRE(found.size() == 2);
  for (const Point& end : {bezier_point(curve, 0.2), bezier_point(curve, 0.7)})
    CHECK(std::min(distance(found[0], end), distance(found[1], end)) < 1e-12);
}

TEST_CASE("overlapping segments of one line meet exactly in the ends of the part that they share", "[boundary]") {
  const std::vector<Point> a{{0, 0}, {2, 1}, {4, 2}}, b{{8, 4}, {5, 2.5}, {2, 1}};
  const auto found = places(a, b);
  REQUIRE(found.size() == 2);
  for (const Point& end : {Point{2, 1}, Point{4, 2}})
    CHECK(std::min(distance(found[0], end), distance(found[1], end)) == 0);
}

TEST_CASE("a common end is not reported, other meetings are", "[boundary]") {
  const std::vector<Point> a{{0, 0}, {0.5, 0}, {1, 1}}, b{{0, 0}, {0.5, 0.25}, {1, 0.5}}, c{{0, 0}, {0.5, 0}, {1, 0.5}};
  CommonEnds common;
  common.start_start = true;
  const auto found = places(a, b, common);
  REQUIRE(found.size() == 1);
  CHECK(distance(found[0], {0.5, 0.25}) < 1e-15);
  CHECK(places(a, c, common).empty());  // a cusp
}

TEST_CASE("random curves meet as often as their samples change sides, in either order and direction",
          "[boundary][property]") {
  const int degree = GENERATE(2, 3, 5);
  std::mt19937 random(static_cast<unsigned>(degree));
  std::uniform_real_distribution<double> coordinate(0, 1);
  const auto monotone = [&](bool up) {
    std::vector<Point> curve(static_cast<std::size_t>(degree) + 1);
    std::vector<double> x, y;
    for (int i = 0; i <= degree; ++i) {
      x.push_back(coordinate(random));
      y.push_back(coordinate(random));
    }
    std::sort(x.begin(), x.end());
    std::sort(y.begin(), y.end());
    if (!up) std::reverse(y.begin(), y.end());
    for (std::size_t i = 0; i < curve.size(); ++i) curve[i] = {x[i], y[i]};
    return curve;
  };
  const auto at_x = [](std::span<const Point> curve, double x) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) (bezier_point(curve, (low + high) / 2).x < x ? low : high) = (low + high) / 2;
    return bezier_point(curve, low).y;
  };
  for (int run = 0; run < 100; ++run) {
    const auto a = monotone(true), b = monotone(run % 2 == 0);
    const double from = std::max(a.front().x, b.front().x), to = std::min(a.back().x, b.back().x);
    std::size_t changes = 0;
    double before = 0;
    for (int i = 0; i <= 400 && from < to; ++i) {
      const double x = from + (to - from) * i / 400, side = at_x(a, x) - at_x(b, x);
      changes += side * before < 0;
      before = side;
    }
    CAPTURE(degree, run);
    CHECK(places(a, b).size() >= changes);
    CHECK((places(a, b).size() - changes) % 2 == 0);
    CHECK(places(a, b).size() == places(b, a).size());
  }
}
