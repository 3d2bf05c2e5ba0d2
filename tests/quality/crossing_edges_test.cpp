// tests/quality/crossing_edges_test.cpp: edges that cross are told from edges that only come close.
#include "pliant/quality/crossing_edges.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "pliant/geometry/predicates.h"
#include "pliant/quality/quality_report.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

void add(EdgeCurves& edges, std::initializer_list<Point> polygon, PointId first, PointId last) {
  edges.points.insert(edges.points.end(), polygon);
  edges.ends.emplace_back(first, last);
}

}  // namespace

TEST_CASE("straight edges cross as often as exact orientation tests say", "[quality][property]") {
  const std::uint64_t seed = GENERATE(range<std::uint64_t>(0, 20));
  const int degree = GENERATE(1, 2, 3);
  CAPTURE(seed, degree);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  EdgeCurves edges;
  edges.degree = degree;
  std::vector<std::pair<Point, Point>> segments;
  for (PointId e = 0; e < 60; ++e) {
    const Point a{uniform(random), uniform(random)}, b = a + 0.5 * Point{uniform(random), uniform(random)};
    segments.emplace_back(a, b);
    edges.ends.emplace_back(2 * e, 2 * e + 1);
    for (int k = 0; k <= degree; ++k) edges.points.push_back((double(degree - k) * a + double(k) * b) / degree);
  }
  std::int64_t expected = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [a, b] = segments[i];
      const auto& [c, d] = segments[j];
      expected += orient2d(a, b, c) != orient2d(a, b, d) && orient2d(c, d, a) != orient2d(c, d, b) ? 1 : 0;
    }
  }
  CHECK(std::ssize(find_crossings(edges)) == expected);
}

TEST_CASE("curves that share a vertex cross only where they meet again", "[quality]") {
  EdgeCurves edges;
  edges.degree = 2;
  SECTION("a smooth joint is no crossing") {
    add(edges, {{0, 0}, {1, 1}, {2, 1}}, 0, 1);
    add(edges, {{2, 1}, {3, 1}, {4, 0}}, 1, 2);
    CHECK(std::ssize(find_crossings(edges)) == 0);
  }
  SECTION("a straight joint is no crossing") {
    add(edges, {{0, 0}, {1, 1}, {2, 2}}, 0, 1);
    add(edges, {{2, 2}, {3, 3}, {4, 4}}, 1, 2);
    CHECK(std::ssize(find_crossings(edges)) == 0);
  }
  SECTION("a cusp is no crossing") {
    add(edges, {{0, 0}, {1, 0}, {2, 1}}, 0, 1);
    add(edges, {{0, 0}, {1, 0}, {2, -1}}, 0, 2);
    CHECK(std::ssize(find_crossings(edges)) == 0);
  }
  SECTION("a cusp of curves to the same side is no crossing") {
    add(edges, {{0, 0}, {1, 0}, {2, 2}}, 0, 1);
    add(edges, {{0, 0}, {1, 0}, {2, 1}}, 0, 2);
    CHECK(std::ssize(find_crossings(edges)) == 0);
  }
  SECTION("a lens of two curves with both ends in common is no crossing") {
    add(edges, {{0, 0}, {1, 1}, {2, 0}}, 0, 1);
    add(edges, {{0, 0}, {1, -1}, {2, 0}}, 0, 1);
    CHECK(std::ssize(find_crossings(edges)) == 0);
  }
  SECTION("a narrow angle is no crossing") {
    add(edges, {{0, 0}, {1, 0}, {2, 0}}, 0, 1);
    add(edges, {{0, 0}, {1, 1e-9}, {2, 2e-9}}, 0, 2);
    CHECK(std::ssize(find_crossings(edges)) == 0);
  }
  SECTION("two that meet a second time cross") {
    add(edges, {{0, 0}, {1, 2}, {2, 0}}, 0, 1);
    add(edges, {{0, 0}, {1, 0.2}, {2, 0.8}}, 0, 2);
    CHECK(std::ssize(find_crossings(edges)) == 1);
  }
}

TEST_CASE("curves without a common vertex also count where they touch", "[quality]") {
  EdgeCurves edges;
  edges.degree = 2;
  add(edges, {{-1, 1}, {0, -1}, {1, 1}}, 0, 1);
  SECTION("tangent from below") { add(edges, {{-1, -1}, {0, 1}, {1, -1}}, 2, 3); }
  SECTION("the very same curve") { add(edges, {{-1, 1}, {0, -1}, {1, 1}}, 2, 3); }
  SECTION("an end on it") { add(edges, {{0, 0}, {0, -1}, {0, -2}}, 2, 3); }
  SECTION("twice crossed") { add(edges, {{-1, 0.5}, {0, 0.5}, {1, 0.5}}, 2, 3); }
  CHECK(std::ssize(find_crossings(edges)) == 1);
}

TEST_CASE("a gap of a millionth is no crossing", "[quality]") {
  EdgeCurves edges;
  edges.degree = 2;
  add(edges, {{-1, 1}, {0, -1}, {1, 1}}, 0, 1);
  add(edges, {{-1, 1 - 1e-6}, {0, -1 - 1e-6}, {1, 1 - 1e-6}}, 2, 3);
  add(edges, {{-1, -1 - 2e-6}, {0, 1 - 2e-6}, {1, -1 - 2e-6}}, 4, 5);
  CHECK(std::ssize(find_crossings(edges)) == 0);
}

TEST_CASE("two cells pushed into each other overlap", "[quality]") {
  const double gap = GENERATE(0.01, -0.01);
  CAPTURE(gap);
  samples::MeshBuilder builder(2);
  samples::add_disk(builder, 16, {0, 0}, 1, "left");
  const double radius = 1;  // control points lie on this circle; the spline reaches a little less far
  const BSpline outline = samples::round_spline(2, 16, {0, 0}, radius);
  double reach = 0;
  for (int k = 0; k <= 1600; ++k) reach = std::max(reach, outline.evaluate(16 * k / 1600.0).x);
  samples::add_disk(builder, 16, {2 * reach + gap, 0}, 1, "right");
  CHECK((report_quality(builder.data()).overlaps > 0) == (gap < 0));
}
