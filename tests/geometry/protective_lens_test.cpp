// tests/geometry/protective_lens_test.cpp: lenses contain their curves, and do not depend on direction, place or size.
#include "pliant/geometry/spline/protective_lens.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace pliant;

TEST_CASE("a straight edge is protected by its diametral circle", "[geometry][property]") {
  const std::vector<Point> line{{-1, 0}, {0, 0}, {1, 0}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-2, 2);
  for (int i = 0; i < 500; ++i) {
    const Point p{unit(random), unit(random)};
    CHECK(is_encroached(line, p) == (length(p) < 1));
  }
  CHECK_FALSE(is_encroached(line, {-1, 0}));
  CHECK_FALSE(is_encroached(line, {1, 0}));
  CHECK_FALSE(is_encroached(line, {0, 1}));
}

TEST_CASE("a lens contains the curve, and on the other side it is the circle", "[geometry][property]") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 100; ++trial) {
    CAPTURE(trial);
    const std::vector<Point> polygon{{-1, 0}, {-0.8 + 1.6 * unit(random), 4 * unit(random)}, {1, 0}};
    for (int i = 1; i < 50; ++i) {
      const double s = i / 50.0;
      CHECK(is_encroached(polygon, (1 - s) * (1 - s) * polygon[0] + 2 * s * (1 - s) * polygon[1] + s * s * polygon[2]));
    }
    const Point below{2 * unit(random) - 1, -2 * unit(random)};
    CHECK(is_encroached(polygon, below) == (length(below) < 1));
    CHECK_FALSE(is_encroached(polygon, {0, 4}));
  }
}

TEST_CASE("a lens does not depend on the curve's direction, place or size", "[geometry][property]") {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(-2, 2);
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<Point> polygon{{-1, 0}, {unit(random), unit(random)}, {unit(random), unit(random)}, {1, 0}};
    const Point p{unit(random), unit(random)};
    const std::vector<Point> reversed(polygon.rbegin(), polygon.rend());
    std::vector<Point> moved;
    for (const Point& b : polygon) moved.push_back(8 * perpendicular(b));
    CHECK(is_encroached(polygon, p) == is_encroached(reversed, p));
    CHECK(is_encroached(polygon, p) == is_encroached(moved, 8 * perpendicular(p)));
  }
}
