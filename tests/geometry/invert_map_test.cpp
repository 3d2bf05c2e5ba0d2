#include "pliant/geometry/invert_map.h"  // tests/geometry/invert_map_test.cpp

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/validity.h"
#include "support/triangles.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

Point image(int degree, const std::vector<Point>& net, const Barycentric& xi) {
  std::vector<double> rows;
  for (const Point& p : net) rows.insert(rows.end(), {p.x, p.y});
  double value[2];
  evaluate_net(degree, 2, rows, xi, value);
  return {value[0], value[1]};
}

double difference(const Barycentric& a, const Barycentric& b) {
  return std::max({std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]), std::fabs(a[2] - b[2])});
}

/// Valid and strongly bent: a half ring of inner radius 1, outer 3, cut by its diagonal; quadratic arcs.
std::vector<Point> bent_net() { return {{3, 0}, {0, 3}, {1, 0}, {3, 3}, {0.4, 1.6}, {2, 0}}; }

}  // namespace

TEST_CASE("Newton gives back the coordinates that were mapped", "[geometry][property]") {
  const int degree = GENERATE(range(1, max_degree + 1));
  const int seed = GENERATE(range(0, 10));
  CAPTURE(degree, seed);
  const auto net = random_valid_net(degree, seed);
  for (const Barycentric& xi : lattice(5)) {
    const auto found = invert_map(degree, net, image(degree, net, xi), 1e-12);
    REQUIRE(found);
    CHECK(difference(*found, xi) < 1e-11);
  }
}

TEST_CASE("Newton follows the element a little beyond its edges", "[geometry]") {
  const auto net = random_valid_net(2, 3);
  const Barycentric outside{-0.05, 0.4, 0.65};
  const auto found = invert_map(2, net, image(2, net, outside), 1e-12);
  REQUIRE(found);
  CHECK(difference(*found, outside) < 1e-11);
}

TEST_CASE("Newton refuses what is farther outside than its reach", "[geometry]") {
  const auto net = straight_net(1, {0, 0}, {1, 0}, {0, 1});
  CHECK(!invert_map(1, net, {5, 5}, 1e-12));
  CHECK(invert_map(1, net, {1.2, 0.5}, 1e-12, nullptr, 1.0));
  CHECK(!invert_map(1, net, {1.2, 0.5}, 1e-12, nullptr, 0.1));
}

TEST_CASE("a start near the solution is used", "[geometry]") {
  const auto net = bent_net();
  const Barycentric xi{0.2, 0.3, 0.5};
  const Barycentric start{0.25, 0.25, 0.5};
  const auto found = invert_map(2, net, image(2, net, xi), 1e-12, &start);
  REQUIRE(found);
  CHECK(difference(*found, xi) < 1e-11);
}

TEST_CASE("subdivision finds every point of bent and of nearly degenerate elements", "[geometry][property]") {
  std::vector<std::pair<int, std::vector<Point>>> elements{{2, bent_net()},
                                                           {2, power_net(2, {0.375, -0x1p-10})},
                                                           {3, power_net(3, {-0x1p-6, 0.375})},
                                                           {4, power_net(4, {-0.125, -0.125})}};
  for (int seed = 0; seed < 40; ++seed) elements.emplace_back(1 + seed % 5, random_valid_net(1 + seed % 5, seed));
  for (const auto& [degree, net] : elements) {
    REQUIRE(certify(degree, net) == Validity::valid);
    for (const Barycentric& xi : lattice(7)) {
      CAPTURE(degree, xi);
      const Point p = image(degree, net, xi);
      const auto found = invert_map_by_subdivision(degree, net, p, 1e-12);
      REQUIRE(found);
      CHECK(distance(image(degree, net, *found), p) <= 2e-12);
      CHECK(*std::min_element(found->begin(), found->end()) >= -1e-12);
    }
  }
}

TEST_CASE("subdivision says no to points outside the element", "[geometry][property]") {
  for (int seed = 0; seed < 100; ++seed) {
    const int degree = 1 + seed % 4;
    CAPTURE(seed, degree);
    const auto net = random_valid_net(degree, seed, 0.05);
    Box box;
    for (const Point& p : net) box.extend(p);
    CHECK(!invert_map_by_subdivision(degree, net, box.high + Point{0.01, 0.01}, 1e-12));
    // Just across the middle of an edge, by its normal.
    const Point a = image(degree, net, {0.501, 0.499, 0});
    const Point b = image(degree, net, {0.499, 0.501, 0});
    const Vector outward = -perpendicular(b - a) / distance(a, b);
    const Point middle = image(degree, net, {0.5, 0.5, 0});
    CHECK(!invert_map_by_subdivision(degree, net, middle + 1e-6 * outward, 1e-12));
    CHECK(invert_map_by_subdivision(degree, net, middle - 1e-6 * outward, 1e-12));
  }
}
