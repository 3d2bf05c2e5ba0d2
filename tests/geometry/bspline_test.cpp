// tests/geometry/bspline_test.cpp: B-splines as curves: extraction, derivatives, interpolation, area and length.
#include "pliant/geometry/spline/bspline.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/random_splines.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

std::vector<Point> extracted(const BSpline& curve, double t0) {
  std::vector<Point> polygon(static_cast<std::size_t>(curve.degree()) + 1);
  curve.extract(t0, polygon);
  return polygon;
}

Point bezier(std::vector<Point> b, double s) {
  for (std::size_t n = b.size() - 1; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i) b[i] = (1 - s) * b[i] + s * b[i + 1];
  return b[0];
}

/// The r-th derivative at one end of a Bézier curve over a parameter interval of length h.
Point end_derivative(std::vector<Point> b, int r, double h, bool at_end) {
  for (int n = 0; n < r; ++n) {
    const double factor = static_cast<double>(b.size() - 1) / h;
    for (std::size_t i = 0; i + 1 < b.size(); ++i) b[i] = factor * (b[i + 1] - b[i]);
    b.pop_back();
  }
  return at_end ? b.back() : b.front();
}

}  // namespace

TEST_CASE("extracted spans trace the curve, meet bit for bit, and are C^(p - m) at their breaks",
          "[geometry][property]") {
  EVERY_CURVE
  const auto breaks = curve.breaks();
  REQUIRE(curve.span_count() + 1 == static_cast<int>(breaks.size()));
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
    const auto here = extracted(curve, breaks[s]);
    const double h = breaks[s + 1] - breaks[s];
    for (int i = 0; i <= 10; ++i)
      CHECK(distance(bezier(here, i / 10.0), curve.evaluate(breaks[s] + h * i / 10)) < 1e-13);
    if (s + 2 == breaks.size() && !closed) continue;
    const std::size_t after = s + 2 < breaks.size() ? s + 1 : 0;
    const auto next = extracted(curve, breaks[after]);
    CHECK(here.back() == next.front());
    const double next_h = breaks[after + 1] - breaks[after];
    for (int r = 1; r <= degree - curve.multiplicity(breaks[after]); ++r) {
      const Point left = end_derivative(here, r, h, true), right = end_derivative(next, r, next_h, false);
      CHECK(distance(left, right) <= 1e-10 * std::pow(std::max(1 / h, 1 / next_h), r) + 1e-10);
    }
  }
  if (!closed) {
    CHECK(extracted(curve, breaks.front()).front() == curve.points().front());
    CHECK(extracted(curve, breaks[breaks.size() - 2]).back() == curve.points().back());
  }
  END_EVERY_CURVE
}

TEST_CASE("a curve of multiplicity p is its own extraction, bit for bit", "[geometry]") {
  const BSpline open(3, false, {0, 0, 0, 0, .1, .1, .1, .7, .7, .7, .7},
                     {{.1, .2}, {.3, .1}, {.7, .9}, {.2, .3}, {.5, .4}, {-.1, .6}, {.9, .9}});
  for (std::size_t s = 0; s < 2; ++s) {
    const auto polygon = extracted(open, s == 0 ? 0 : .1);
    for (std::size_t i = 0; i < 4; ++i) CHECK(polygon[i] == open.points()[3 * s + i]);
  }
}

TEST_CASE("derivatives agree with differences on either side of a break", "[geometry][property]") {
  EVERY_CURVE
  for (const double t : parameters(curve, 13)) {
    const double h = 1e-6;
    if (t + h < curve.last_parameter() && curve.multiplicity(t) <= 1 && curve.span_end(t) - t > 2 * h) {
      const Vector ahead = (curve.evaluate(t + h) - curve.evaluate(t)) / h;
      CHECK(distance(curve.derivative(t), ahead) < 1e-2);
    }
    if (t - h > curve.first_parameter() && t - curve.span_before(t) > 2 * h) {
      const Vector behind = (curve.evaluate(t) - curve.evaluate(t - h)) / h;
      const Vector exact = t == curve.last_parameter() && closed ? curve.derivative(curve.first_parameter(), true)
                                                                 : curve.derivative(t, true);
      CHECK(distance(exact, behind) < 1e-2);
    }
  }
  END_EVERY_CURVE
}

TEST_CASE("interpolation at the Greville abscissae reproduces every curve of the space", "[geometry][property]") {
  EVERY_CURVE
  const auto greville = curve.greville();
  std::vector<Point> values;
  for (const double t : greville) {
    CHECK(t >= curve.first_parameter());
    CHECK(t <= curve.last_parameter());
    values.push_back(curve.evaluate(t));
  }
  BSpline other = curve;
  for (std::size_t i = 0; i < values.size(); ++i) other.set_point(static_cast<int>(i), {});
  REQUIRE(other.interpolate(values));
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(distance(other.points()[i], curve.points()[i]) < 2e-13);
  END_EVERY_CURVE
}

TEST_CASE("interpolation keeps ends, points at knots of multiplicity p, and polynomials", "[geometry]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(degree, seed);
    BSpline curve = random_curve(degree, false, seed);
    const auto greville = curve.greville();
    const auto polynomial = [degree](double t) { return Point{t, 1 - t + std::pow(t, degree) / 3}; };
    std::vector<Point> values;
    for (const double t : greville) values.push_back(polynomial(t));
    REQUIRE(curve.interpolate(values));
    for (const double t : parameters(curve))
      CHECK(distance(curve.evaluate(t), polynomial(t)) < 1e-11 * (1 + std::pow(std::fabs(t), degree)));
    CHECK(curve.points().front() == values.front());
    CHECK(curve.points().back() == values.back());
    for (std::size_t i = 0; i < greville.size(); ++i)
      if (curve.multiplicity(greville[i]) == degree) CHECK(curve.points()[i] == values[i]);
  }
}

TEST_CASE("interpolation works for thousands of points, on closed curves too", "[geometry]") {
  const int degree = GENERATE(2, 3, 5);
  const int count = 5000;
  std::vector<double> knots;
  std::vector<Point> points;
  std::mt19937 random(5);
  for (int i = 0; i <= count; ++i)
    knots.push_back(i + 0.9 * (i % count == 0 ? 0 : std::generate_canonical<double, 53>(random)));
  for (int i = 0; i < count; ++i) points.push_back({std::cos(i * 0.01), std::sin(i * 0.013)});
  const BSpline curve(degree, true, knots, points);
  std::vector<Point> values;
  for (const double t : curve.greville()) values.push_back(curve.evaluate(t));
  BSpline other(degree, true, knots, std::vector<Point>(points.size()));
  REQUIRE(other.interpolate(values));
  double most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) most = std::max(most, distance(points[i], other.points()[i]));
  CHECK(most < 1e-11);
}

TEST_CASE("area and length are those of known shapes", "[geometry]") {
  CHECK(unit_square.area() == 1);
  CHECK(unit_square.arc_length() == Approx(4).epsilon(1e-14));
  // A cubic periodic spline through many points of a circle, far from the origin.
  const int count = 400;
  std::vector<double> knots;
  std::vector<Point> values;
  for (int i = 0; i <= count; ++i) knots.push_back(i);
  BSpline circle(3, true, knots, std::vector<Point>(count));
  for (const double t : circle.greville()) {
    const double angle = 2 * std::numbers::pi * t / count;
    values.push_back(Point{100, -50} + Point{std::cos(angle), std::sin(angle)});
  }
  REQUIRE(circle.interpolate(values));
  CHECK(circle.area() == Approx(std::numbers::pi).epsilon(1e-8));
  CHECK(circle.arc_length() == Approx(2 * std::numbers::pi).epsilon(1e-8));
  // y = x^2 from 0 to 1: length sqrt(5)/2 + asinh(2)/4.
  const BSpline parabola(2, false, {0, 0, 0, 1, 1, 1}, {{0, 0}, {0.5, 0}, {1, 1}});
  CHECK(parabola.arc_length() == Approx(std::sqrt(5.0) / 2 + std::asinh(2.0) / 4).epsilon(1e-13));
  CHECK(parabola.area() == Approx(1.0 / 6).epsilon(1e-14));
}
