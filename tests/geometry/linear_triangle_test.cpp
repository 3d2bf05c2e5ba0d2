// tests/geometry/linear_triangle_test.cpp: measures of straight triangles where closed forms know them.
#include "pliant/geometry/linear_triangle.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

using namespace pliant;

TEST_CASE("the equilateral triangle is the best one by every measure", "[geometry]") {
  const Point a{1, 2}, b{3, 2}, c{2, 2 + std::numbers::sqrt3};
  CHECK(triangle_area(a, b, c) == Approx(std::numbers::sqrt3));
  CHECK(triangle_shape(a, b, c) == Approx(1));
  CHECK(triangle_shape(b, a, c) == Approx(-1));
  CHECK(least_angle(a, b, c) == Approx(std::numbers::pi / 3));
  CHECK(radius_edge_ratio(a, b, c) == Approx(1 / std::numbers::sqrt3));
}

TEST_CASE("a flat triangle has shape and angle zero and an infinite radius", "[geometry]") {
  const Point a{0, 0}, b{1, 1}, c{3, 3};
  CHECK(triangle_shape(a, b, c) == 0);
  CHECK(triangle_shape(a, a, a) == 0);
  CHECK(least_angle(a, b, c) == 0);
  CHECK(std::isinf(radius_edge_ratio(a, b, c)));
  CHECK_FALSE(is_finite(circumcenter(a, b, c)));
}

TEST_CASE("circumcentres are equally far from all corners, and barycentric coordinates reproduce the point",
          "[geometry][property]") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&] { return Point{unit(random), unit(random)}; };
  for (int i = 0; i < 300; ++i) {
    const Point a = point(), b = point(), c = point(), p = point();
    if (std::fabs(triangle_area(a, b, c)) < 1e-2) continue;
    const Point o = circumcenter(a, b, c);
    const double radius = distance(o, a), shortest = std::min({distance(a, b), distance(b, c), distance(c, a)});
    CHECK(distance(o, b) == Approx(radius));
    CHECK(distance(o, c) == Approx(radius));
    CHECK(radius_edge_ratio(a, b, c) == Approx(radius / shortest));
    // The sine rule: the least angle is opposite to the shortest edge.
    CHECK(std::sin(least_angle(a, b, c)) == Approx(shortest / (2 * radius)));
    const Barycentric xi = barycentric(a, b, c, p);
    CHECK(xi[0] + xi[1] + xi[2] == Approx(1));
    CHECK(distance(xi[0] * a + xi[1] * b + xi[2] * c, p) < 1e-12);
  }
}
