// tests/geometry/restore_area_test.cpp: a closed curve offset until it encloses a given area.
#include "pliant/geometry/spline/restore_area.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace pliant;

namespace {

/// A closed curve of `count` uniform spans whose points at the Greville abscissae lie on an ellipse.
BSpline ellipse(int degree, int count, double a, double b) {
  std::vector<double> knots;
  for (int i = 0; i <= count; ++i) knots.push_back(i);
  BSpline curve(degree, true, knots, std::vector<Point>(static_cast<std::size_t>(count)));
  std::vector<Point> places;
  for (const double t : curve.greville()) {
    const double angle = 2 * std::numbers::pi * t / count;
    places.push_back({a * std::cos(angle), b * std::sin(angle)});
  }
  REQUIRE(curve.interpolate(places));
  return curve;
}

}  // namespace

TEST_CASE("an offset gives a closed curve the area asked for", "[geometry]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const double factor = GENERATE(0.9, 1 - 1e-9, 1 + 1e-6, 1.1);
  CAPTURE(degree, factor);
  BSpline curve = ellipse(degree, 24, 2, 1);
  const double wanted = factor * curve.area(), change = wanted - curve.area(), length = curve.arc_length();
  const double offset = restore_area(curve, wanted);
  CHECK(curve.area() == Approx(wanted).epsilon(1e-14));
  CHECK(offset == Approx(change / length).epsilon(0.1));  // outwards is positive; exact in the limit of small changes
}

TEST_CASE("the offset of a circle is the difference of the radii", "[geometry]") {
  BSpline circle = ellipse(3, 200, 1, 1);
  const double offset = restore_area(circle, std::numbers::pi * 1.2 * 1.2);
  CHECK(offset == Approx(0.2).epsilon(1e-7));
  for (const Point& p : circle.points()) CHECK(std::hypot(p.x, p.y) == Approx(1.2).epsilon(1e-3));
}

TEST_CASE("the size and the direction of a curve do not matter", "[geometry]") {
  const double scale = GENERATE(1e-100, 1e-3, 1e100);
  BSpline curve = ellipse(2, 16, scale, -0.5 * scale);  // clockwise: the area is negative
  const double wanted = 1.05 * curve.area();
  CHECK(std::abs(restore_area(curve, wanted)) > 0);
  CHECK(curve.area() == Approx(wanted).epsilon(1e-14));
}

TEST_CASE("a curve stays bit for bit where no offset helps", "[geometry]") {
  BSpline circle = ellipse(2, 16, 1, 1);
  const std::vector<Point> before(circle.points().begin(), circle.points().end());
  CHECK(restore_area(circle, -1) == 0);  // offset inwards, a circle shrinks to nothing and then grows again
  CHECK(std::equal(before.begin(), before.end(), circle.points().begin()));
  BSpline right = ellipse(2, 16, 1, 1);
  const std::vector<Point> kept(right.points().begin(), right.points().end());
  CHECK(restore_area(right, right.area()) == 0);
  CHECK(std::equal(kept.begin(), kept.end(), right.points().begin()));
}
