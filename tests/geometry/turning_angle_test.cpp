// tests/geometry/turning_angle_test.cpp: polygons with known angles turn by their sum.
#include "pliant/geometry/spline/turning_angle.h"

#include <array>
#include <catch2/catch.hpp>
#include <numbers>
#include <vector>

using namespace pliant;

TEST_CASE("a straight polygon does not turn, a square's three corners turn by three right angles", "[geometry]") {
  CHECK(turning_angle(std::vector<Point>{{0, 0}, {1, 1}, {2, 2}, {5, 5}}) == 0);
  CHECK(turning_angle(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}) == Approx(1.5 * std::numbers::pi));
  CHECK(turning_angle(std::vector<Point>{{0, 0}}) == 0);
}

TEST_CASE("turns to the left and to the right add up, and zero legs are skipped", "[geometry]") {
  CHECK(turning_angle(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {2, 1}}) == Approx(std::numbers::pi));
  CHECK(turning_angle(std::vector<Point>{{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 1}}) == Approx(std::numbers::pi / 2));
  CHECK(turning_angle(std::vector<Point>{{0, 0}, {1, 0}, {0, 0}}) == Approx(std::numbers::pi));
}
