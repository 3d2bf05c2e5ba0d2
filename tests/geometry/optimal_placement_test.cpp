// tests/geometry/optimal_placement_test.cpp: best places of one point against places on a grid.
#include "pliant/geometry/placement/optimal_placement.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/placement/shape_bounds.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/geometry/validity/validity.h"

// The star of one control point, everything else fixed; placement is compared with a search on a grid of places.
namespace {
using namespace pliant;
using Net = std::vector<Point>;

struct Star {
  int degree;
  std::vector<Net> nets;
  std::vector<int> moving;

  std::vector<PlacementElement> elements() const {
    std::vector<PlacementElement> all;
    for (std::size_t e = 0; e < nets.size(); ++e) all.push_back({nets[e], moving[e]});
    return all;
  }
  Net net(std::size_t e, const Point& place) const {
    Net result = nets[e];
    result[static_cast<std::size_t>(moving[e])] = place;
    return result;
  }
  bool is_valid(const Point& place) const {
    for (std::size_t e = 0; e < nets.size(); ++e)
      if (certify(degree, net(e, place)) != Validity::valid) return false;
    return true;
  }
  ShapeBounds shape(const Point& place, double width = 1e-3) const {
    ShapeBounds least{1, 1, {}};
    for (std::size_t e = 0; e < nets.size(); ++e) {
      const ShapeBounds bounds = least_shape(degree, net(e, place), width);
      least = {std::min(least.lower, bounds.lower), std::min(least.upper, bounds.upper), bounds.worst};
    }
    return least;
  }
  double least_coefficient(const Point& place) const {
    double least = HUGE_VAL;
    for (std::size_t e = 0; e < nets.size(); ++e) {
      Box box;
      for (std::size_t n = 0; n < nets[e].size(); ++n)
        if (static_cast<int>(n) != moving[e]) box.extend(nets[e][n]);
      std::vector<double> coefficients(static_cast<std::size_t>(net_size(jacobian_degree(degree))));
      jacobian_net(degree, net(e, place), coefficients);
      for (const double c : coefficients) least = std::min(least, c / (box.size() * box.size()));
    }
    return least;
  }
};

/// Bent triangles around a vertex that moves; or one or two with a point that moves on an edge; or one with an inner
/// point that moves.
Star random_star(int degree, unsigned seed, double noise) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const NetLayout& layout = NetLayout::of(degree);
  const int kinds = degree == 1 ? 1 : degree == 2 ? 2 : 3;
  const int kind = static_cast<int>(seed) % kinds;  // vertex, edge, interior
  const int count = kind == 0 ? 3 + static_cast<int>(random() % 4) : kind == 1 ? 2 : 1;
  std::vector<Point> ring;
  for (int k = 0; k < count + 1; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.6 * unit(random)) / std::max(count, 3), r = 0.6 + unit(random);
    ring.push_back(r * Point{std::cos(angle), std::sin(angle)});
  }
  if (count >= 3) ring.back() = ring.front();
  Star star{degree, {}, {}};
  for (int e = 0; e < count; ++e) {
    Net net;
    const Point centre{}, a = ring[static_cast<std::size_t>(e)], b = ring[static_cast<std::size_t>(e) + 1];
    for (int n = 0; n < layout.size(); ++n) {
      const auto& [i, j, k] = layout.exponents(n);
      Point p = (i * centre + j * a + k * b) / degree;
      if (n >= 3) p += noise / degree * Vector{unit(random) - 0.5, unit(random) - 0.5};
      net.push_back(p);
    }
    star.nets.push_back(net);
    star.moving.push_back(kind == 0   ? 0
                          : kind == 1 ? layout.edge_index(e == 0 ? 2 : 0, e == 0 ? degree - 1 : 1)
                                      : layout.first_interior());
  }
  return star;
}

std::vector<Point> grid(double half, int steps) {
  std::vector<Point> places;
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j) places.push_back({half * i / steps, half * j / steps});
  return places;
}

}  // namespace

TEST_CASE("untangling finds a valid place whenever a grid finds one, and if it says hopeless the grid finds none",
          "[geometry][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  int placed = 0, hopeless = 0, stuck = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(degree, seed);
    const Star star = random_star(degree, seed, 1.2);
    const Placement result = untangle_point(degree, star.elements(), {3, 2});
    bool any = false;
    double most = -HUGE_VAL;
    for (const Point& place : grid(1.6, 12)) {
      any = any || star.is_valid(place);
      most = std::max(most, star.least_coefficient(place));
    }
    if (result.outcome == Placement::Outcome::placed) {
      ++placed;
      CHECK(star.is_valid(result.place));
    }
    hopeless += result.outcome == Placement::Outcome::hopeless;
    stuck += result.outcome == Placement::Outcome::stuck;
    if (any) CHECK(result.outcome == Placement::Outcome::placed);
    if (result.outcome != Placement::Outcome::hopeless) CHECK(result.value >= most - 1e-9);
  }
  CAPTURE(degree, placed, hopeless, stuck);
  CHECK(placed > 5);
  CHECK(stuck <= 3);
}

TEST_CASE("improving reaches the best shape that a grid finds, from any valid start", "[geometry][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  int improved = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    CAPTURE(degree, seed);
    const Star star = random_star(degree, seed, 0.5);
    const Placement start = untangle_point(degree, star.elements(), {0.1, 0.2});
    if (start.outcome != Placement::Outcome::placed) continue;
    const ShapeBounds before = star.shape(start.place);
    const Placement result = improve_point(degree, star.elements(), start.place);
    const ShapeBounds after = star.shape(result.place);
    REQUIRE(result.outcome == Placement::Outcome::placed);
    CHECK(star.is_valid(result.place));
    CHECK(after.upper >= before.lower);
    CHECK(result.value <= after.upper);
    CHECK(result.value >= after.lower * 0.99 - 1e-6);
    double most = 0;
    for (const Point& place : grid(1.6, 24)) most = std::max(most, star.shape(place, 1e-2).lower);
    CHECK(after.upper >= most * (1 - 5e-3));
    improved += after.lower > before.upper;
  }
  CHECK(improved > 5);
}

TEST_CASE("a point that is already best stays bit for bit", "[geometry]") {
  // The point is the centre of an equilateral hexagon.
  Star star{1, {}, {}};
  for (int e = 0; e < 6; ++e) {
    const auto corner = [](int k) {
      return Point{std::cos(k * std::numbers::pi / 3), std::sin(k * std::numbers::pi / 3)};
    };
    star.nets.push_back({{0, 0}, corner(e), corner(e + 1)});
    star.moving.push_back(0);
  }
  const Placement result = improve_point(1, star.elements(), {0, 0});
  CHECK(result.place == Point{0, 0});
  CHECK(result.value == Approx(1));
}

TEST_CASE("a corner with an angle of 180 degrees is hopeless if the moving point cannot change it", "[geometry]") {
  // In this element of degree 2, edges 12 and 31 leave corner 1 in opposite directions.
  const Net net{{0, 0}, {1, 1}, {-1, 1}, {0.5, 0}, {0, 1}, {-0.5, 0}};
  const PlacementElement element{net, 4};
  CHECK(untangle_point(2, std::span(&element, 1), {0, 1}).outcome == Placement::Outcome::hopeless);
}

TEST_CASE("placement does not depend on the unit of length", "[geometry]") {
  const double unit = GENERATE(1e-100, 1e-9, 1e9, 1e100);
  CAPTURE(unit);
  Star star = random_star(2, 7, 0.5);
  const Placement plain = untangle_point(2, star.elements(), {0.1, 0.2});
  const Placement best = improve_point(2, star.elements(), plain.place);
  for (Net& net : star.nets)
    for (Point& p : net) p *= unit;
  const Placement scaled = untangle_point(2, star.elements(), unit * Point{0.1, 0.2});
  const Placement scaled_best = improve_point(2, star.elements(), unit * plain.place);
  CHECK(distance(scaled.place / unit, plain.place) < 1e-9);
  CHECK(scaled.value == Approx(plain.value));
  CHECK(distance(scaled_best.place / unit, best.place) < 1e-6);
  CHECK(scaled_best.value == Approx(best.value));
}

TEST_CASE("placement by the measures of the control mesh is optimal on the control mesh", "[geometry][property]") {
  const int degree = GENERATE(1, 2, 3);
  for (unsigned seed = 0; seed < 30; ++seed) {
    CAPTURE(degree, seed);
    const Star star = random_star(degree, seed, 0.3);
    const auto least = [&star, degree](const Point& place) {
      double least_tau = 1;
      const NetLayout& layout = NetLayout::of(degree);
      for (std::size_t e = 0; e < star.nets.size(); ++e) {
        const Net net = star.net(e, place);
        const auto look = [&](int a, int b, int c) {
          const int m = star.moving[e];
          if (a != m && b != m && c != m) return;
          const auto at = [&net](int n) { return net[static_cast<std::size_t>(n)]; };
          least_tau = std::min(least_tau, triangle_shape(at(a), at(b), at(c)));
        };
        for (int i = 0; i < degree; ++i)
          for (int j = 0; i + j < degree; ++j) {
            look(layout.index(i + 1, j), layout.index(i, j + 1), layout.index(i, j));
            if (i + j + 1 < degree) look(layout.index(i + 1, j + 1), layout.index(i, j + 1), layout.index(i + 1, j));
          }
      }
      return least_tau;
    };
    const Placement start = untangle_point(degree, star.elements(), {0.1, 0.2}, PlacementMeasure::control_mesh);
    if (start.outcome != Placement::Outcome::placed) continue;
    const Placement result = improve_point(degree, star.elements(), start.place, PlacementMeasure::control_mesh);
    CHECK(result.value == Approx(least(result.place)).margin(1e-9));
    CHECK(result.value >= least(start.place) - 1e-12);
    // Better places may be known, but not if the best of all makes the elements valid.
    Point best{};
    for (const Point& place : grid(1.6, 40))
      if (least(place) > least(best)) best = place;
    if (star.is_valid(best)) CHECK(result.value >= least(best) - 1e-9);
  }
}

TEST_CASE("a flat element, the sign of whose det J is all rounding, is given up soon", "[geometry]") {
  const Net flat{{-0.16049544091598084, 0.24019840175639592},  {-0.24074316137397134, 0.36029760263459387},
                 {-0.080247720457990335, 0.12009920087819796}, {-0.20061930114497609, 0.30024800219549486},
                 {-0.16049544091598084, 0.2401984017563959},   {-0.12037158068698559, 0.18014880131729694}};
  const Net other{{-0.24074316137397134, 0.36029760263459387},  {-0.29694691124929734, 0.23588395088196834},
                  {-0.080247720457990335, 0.12009920087819796}, {-0.26884503631163437, 0.29809077675828111},
                  {-0.18859731585364387, 0.17799157588008319},  {-0.16049544091598084, 0.2401984017563959}};
  const std::vector<PlacementElement> elements{{flat, 4}, {other, 5}};
  CHECK(untangle_point(2, elements, flat[4]).outcome != Placement::Outcome::placed);
}
