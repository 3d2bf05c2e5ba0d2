// tests/geometry/invert_map_test.cpp: the coordinates of a point in an element are those that were mapped there.
#include "pliant/geometry/invert_map.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/validity/validity.h"
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

/// A valid, strongly bent element: one half of a half ring with radii 1 and 3 and quadratic arcs, cut by its diagonal.
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
      const ElementSearch found = find_in_element(degree, net, p, 1e-12);
      REQUIRE(found.answer == SearchAnswer::found);
      CHECK(distance(image(degree, net, found.xi), p) <= 2e-12);
      CHECK(std::ranges::min(found.xi) >= -1e-12);
    }
  }
}

TEST_CASE("subdivision says no to points outside the element", "[geometry][property]") {
  for (int seed = 0; seed < 100; ++seed) {
    const int degree = 1 + seed % 5;
    CAPTURE(seed, degree);
    const auto net = random_valid_net(degree, seed, 0.05);
    Box box;
    for (const Point& p : net) box.extend(p);
    CHECK(find_in_element(degree, net, box.high + Point{0.01, 0.01}, 1e-12).answer == SearchAnswer::absent);
    // The point is just outside the middle of an edge, along its normal.
    const Point a = image(degree, net, {0.501, 0.499, 0});
    const Point b = image(degree, net, {0.499, 0.501, 0});
    const Vector outward = -perpendicular(b - a) / distance(a, b);
    const Point middle = image(degree, net, {0.5, 0.5, 0});
    for (const double off : {1e-2, 1e-6, 1e-9, 1e-11}) {
      CHECK(find_in_element(degree, net, middle + off * outward, 1e-13).answer == SearchAnswer::absent);
      CHECK(find_in_element(degree, net, middle - off * outward, 1e-13).answer == SearchAnswer::found);
    }
  }
}

TEST_CASE("the answer does not depend on where the element lies nor on its size", "[geometry][property]") {
  for (int seed = 0; seed < 20; ++seed) {
    const int degree = 1 + seed % 5;
    auto net = random_valid_net(degree, seed);
    for (const double scale : {0x1p-900, 0x1p-300, 1.0, 0x1p400}) {
      CAPTURE(seed, degree, scale);
      auto scaled = net;
      for (Point& p : scaled) p *= scale;
      for (const Barycentric& xi : lattice(4)) {
        const Point p = scale * image(degree, net, xi);
        const ElementSearch found = find_in_element(degree, scaled, p, scale * 1e-13);
        REQUIRE(found.answer == SearchAnswer::found);
        CHECK(distance(image(degree, scaled, found.xi) / scale, p / scale) <= 1e-12);
      }
      const Point beyond = scale * image(degree, net, {-1e-6, 0.4, 0.600001});
      CHECK(find_in_element(degree, scaled, beyond, scale * 1e-13).answer == SearchAnswer::absent);
    }
    for (Point& p : net) p += {1e9, -1e9};
    CHECK(find_in_element(degree, net, image(degree, net, {0.2, 0.5, 0.3}), 1e-6).answer == SearchAnswer::found);
    CHECK(find_in_element(degree, net, image(degree, net, {-1e-5, 0.5, 0.50001}), 1e-9).answer == SearchAnswer::absent);
  }
}

TEST_CASE("elements with a cusp are searched up to the corner of the cusp", "[geometry]") {
  // The map (s + t, t (s + t)) fills the region between the line y = 0 and the parabola y = x^2. It is turned so that
  // boxes do not fit.
  std::vector<Point> net{{0, 0}, {1, 0}, {1, 1}, {0.5, 0}, {1, 0.5}, {0.5, 0}};
  const auto turned = [](const Point& p) { return Point{0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y}; };
  for (Point& p : net) p = turned(p);
  REQUIRE(certify_cusp(2, net, 0) == Validity::valid);
  CHECK(find_in_element(2, net, {0, 0}, 1e-14).answer == SearchAnswer::found);
  for (int k = 1; k <= 6; ++k) {
    const double x = std::pow(10.0, -k);
    CAPTURE(x);
    for (const double share : {0.01, 0.5, 0.99}) {
      const Point p = turned({x, share * x * x});
      const ElementSearch found = find_in_element(2, net, p, 1e-14);
      REQUIRE(found.answer == SearchAnswer::found);
      CHECK(distance(image(2, net, found.xi), p) <= 2e-14);
    }
    CHECK(find_in_element(2, net, turned({x, 1.01 * x * x}), 1e-14).answer == SearchAnswer::absent);
    CHECK(find_in_element(2, net, turned({x, -0.01 * x * x}), 1e-14).answer == SearchAnswer::absent);
    CHECK(find_in_element(2, net, turned({-x, 0}), 1e-14).answer == SearchAnswer::absent);
  }
}

TEST_CASE("elements that lie over themselves have all their points found, and nothing else", "[geometry][property]") {
  // The map is z^5 around a point just outside the element: det J > 0, yet the image winds by more than one turn.
  const auto net = power_net(5, {-0x1p-4, -0x1p-4});
  REQUIRE(certify(5, net) == Validity::valid);
  for (const Barycentric& xi : lattice(12))
    CHECK(find_in_element(5, net, image(5, net, xi), 1e-12).answer == SearchAnswer::found);
  const auto folded = random_integer_net(3, 5, 2, 12);
  for (const Barycentric& xi : lattice(12))
    CHECK(find_in_element(3, folded, image(3, folded, xi), 1e-12).answer == SearchAnswer::found);
}
