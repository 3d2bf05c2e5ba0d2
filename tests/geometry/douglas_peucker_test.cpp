// tests/geometry/douglas_peucker_test.cpp: simplified polylines stay within the tolerance, and keep their corners.
#include "pliant/geometry/spline/douglas_peucker.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace {
using namespace pliant;

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const double square = squared_length(b - a);
  const double s = square > 0 ? std::clamp(dot(p - a, b - a) / square, 0.0, 1.0) : 0;
  return distance(p, a + s * (b - a));
}

/// How far a dropped point is from the segment that replaces it.
double deviation(const std::vector<Point>& line, const std::vector<bool>& kept, bool closed) {
  const std::size_t n = line.size();
  double most = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (kept[i]) continue;
    std::size_t before = i, after = i;
    while (!kept[before]) before = (before + n - 1) % n;
    while (!kept[after]) after = (after + 1) % n;
    REQUIRE((closed || (before < i && i < after)));
    most = std::max(most, distance_to_segment(line[i], line[before], line[after]));
  }
  return most;
}

}  // namespace

TEST_CASE("every dropped point is within the tolerance of the kept ones", "[geometry][property]") {
  const bool closed = GENERATE(false, true);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Point> line;
    const int n = 1 + static_cast<int>(random() % 200);
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      line.push_back(Point{std::cos(angle), std::sin(2 * angle)} + 0.03 * Point{unit(random), unit(random)});
    }
    const double tolerance = 0.005 * (1 + trial % 10);
    CAPTURE(closed, trial, n);
    const auto kept = douglas_peucker(line, closed, tolerance);
    REQUIRE(kept.size() == line.size());
    CHECK(deviation(line, kept, closed) <= tolerance);
  }
}

TEST_CASE("ends are kept, points on a line are dropped, and a tolerance of zero keeps every turn", "[geometry]") {
  const std::vector<Point> line{{0, 0}, {1, 0}, {2, 0}, {3, 1}, {4, 2}};
  CHECK(douglas_peucker(line, false, 0) == std::vector<bool>{true, false, true, false, true});
  CHECK(douglas_peucker(line, false, 10) == std::vector<bool>{true, false, false, false, true});
  CHECK(douglas_peucker(std::vector<Point>{}, true, 1).empty());
  CHECK(douglas_peucker(std::vector<Point>{{1, 1}}, true, 1) == std::vector<bool>{true});
}

TEST_CASE("a closed polyline keeps its corners wherever it starts", "[geometry]") {
  std::vector<Point> square;
  for (const auto& [from, to] :
       {std::pair<Point, Point>{{0, 0}, {4, 0}}, {{4, 0}, {4, 4}}, {{4, 4}, {0, 4}}, {{0, 4}, {0, 0}}})
    for (int i = 0; i < 4; ++i) square.push_back(from + i / 4.0 * (to - from));
  for (std::size_t start = 0; start < square.size(); ++start) {
    const auto kept = douglas_peucker(square, true, 1e-9);
    for (std::size_t i = 0; i < square.size(); ++i)
      CHECK(kept[i] == (std::fmod(square[i].x, 4) == 0 && std::fmod(square[i].y, 4) == 0));
    std::rotate(square.begin(), square.begin() + 1, square.end());
  }
}
