// tests/geometry/resolution_test.cpp: the estimate of a spline's error against curves that are known.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "pliant/geometry/spline/bspline.h"

using namespace pliant;

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// A smooth closed curve with many bends.
Point flower(double t) {
  const double radius = 1 + 0.2 * std::sin(3 * t);
  return {radius * std::cos(t), radius * std::sin(t)};
}

/// The closed spline through flower(t) at the Greville abscissae; spans differ by a factor of up to `spread`.
BSpline spline_through_flower(int degree, int spans, double spread) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> length(1, spread);
  std::vector<double> knots{0};
  for (int i = 0; i < spans; ++i) knots.push_back(knots.back() + (spread > 1 ? length(random) : 1));
  for (double& knot : knots) knot *= two_pi / knots.back();
  knots.back() = two_pi;
  BSpline curve(degree, true, knots, std::vector<Point>(static_cast<std::size_t>(spans)));
  std::vector<Point> values;
  for (const double t : curve.greville()) values.push_back(flower(t));
  REQUIRE(curve.interpolate(values));
  return curve;
}

double largest_estimate(const BSpline& curve) {
  double largest = 0;
  const std::vector<double> breaks = curve.breaks();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) largest = std::max(largest, curve.resolution_error(breaks[i]));
  return largest;
}

double largest_error(const BSpline& curve) {
  double largest = 0;
  for (int i = 0; i < 5000; ++i) {
    const double t = two_pi * i / 5000;
    largest = std::max(largest, distance(curve.evaluate(t), flower(t)));
  }
  return largest;
}

}  // namespace

TEST_CASE("the resolution error of a spline is near its distance from the curve that it interpolates",
          "[geometry][property]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const int spans = GENERATE(60, 120);
  const double spread = GENERATE(1.0, 2.0);
  CAPTURE(degree, spans, spread);
  const BSpline curve = spline_through_flower(degree, spans, spread);
  const double ratio = largest_estimate(curve) / largest_error(curve);
  CHECK(ratio > 0.5);
  CHECK(ratio < 30);  // equal spans of even degree and high degrees do better than the bound
}

TEST_CASE("the resolution error falls with order degree + 1", "[geometry][property]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  CAPTURE(degree);
  const double coarse = largest_estimate(spline_through_flower(degree, 100, 1));
  const double fine = largest_estimate(spline_through_flower(degree, 200, 1));
  CHECK(std::log2(coarse / fine) == Approx(degree + 1).margin(0.2));
}

TEST_CASE("the resolution error scales with the points, not with the knots, and vanishes on straight curves",
          "[geometry][property]") {
  const int degree = GENERATE(1, 2, 3, 5);
  CAPTURE(degree);
  BSpline curve = spline_through_flower(degree, 30, 2);
  std::vector<double> knots = curve.knots().to_vector();
  std::vector<Point> points = curve.points().to_vector();
  for (double& knot : knots) knot *= 8;
  for (Point& p : points) p *= 4;
  const BSpline scaled(degree, true, knots, points);
  const std::vector<double> breaks = curve.breaks();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    CHECK(scaled.resolution_error(8 * breaks[i]) == Approx(4 * curve.resolution_error(breaks[i])));
  // A straight curve with even speed, on uneven knots.
  BSpline line(degree, true, curve.knots().to_vector(), points);
  line = BSpline(
      degree, false,
      [&] {
        std::vector<double> clamped(static_cast<std::size_t>(degree), 0.0);
        for (const double t : breaks) clamped.push_back(t);
        clamped.insert(clamped.end(), static_cast<std::size_t>(degree), breaks.back());
        return clamped;
      }(),
      std::vector<Point>(breaks.size() + static_cast<std::size_t>(degree) - 1));
  std::vector<Point> values;
  for (const double t : line.greville()) values.push_back({3 * t, 1 - t});
  REQUIRE(line.interpolate(values));
  CHECK(largest_estimate(line) < 1e-12);
}

TEST_CASE("only jumps at simple knots count, and an arc is told by its turning", "[geometry]") {
  const int degree = GENERATE(2, 3, 4);
  CAPTURE(degree);
  // Two straight Bézier pieces that meet in a corner: the corner is meant.
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0);
  knots.insert(knots.end(), static_cast<std::size_t>(degree), 1);
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 2);
  std::vector<Point> points;
  for (int i = 0; i <= degree; ++i) points.push_back({double(i) / degree, 0});
  for (int i = 1; i <= degree; ++i) points.push_back({1, double(i) / degree});
  const BSpline corner(degree, false, knots, points);
  CHECK(corner.resolution_error(0) == 0);
  CHECK(corner.resolution_error(1) == 0);
  // A quarter of a circle, about: one span, without neighbours.
  for (int i = 0; i <= degree; ++i) {
    const double angle = std::numbers::pi / 2 * i / degree;
    points[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
  }
  const BSpline arc(degree, false, knots, points);
  CHECK(arc.resolution_error(0) > 1e-3);
}
