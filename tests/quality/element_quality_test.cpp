// tests/quality/element_quality_test.cpp: measures of single elements against closed formulas and samples.
#include "pliant/quality/element/element_quality.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/quadrature.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/quality/too_curved.h"

using namespace pliant;

namespace {

using Net = std::vector<Point>;

/// The net of the straight element with these corners: its control points form a regular lattice.
Net affine_net(int degree, const Point& a, const Point& b, const Point& c) {
  Net net;
  const NetLayout& layout = NetLayout::of(degree);
  for (int n = 0; n < layout.size(); ++n) {
    const auto [i, j, k] = layout.exponents(n);
    net.push_back((double(i) * a + double(j) * b + double(k) * c) / degree);
  }
  return net;
}

Net random_net(int degree, double noise, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-noise, noise);
  Net net = affine_net(degree, {0, 0}, {1, 0.1}, {0.3, 0.9});
  for (Point& p : net) p += {uniform(random), uniform(random)};
  return net;
}

std::vector<Barycentric> lattice(int n) {
  std::vector<Barycentric> points;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) points.push_back({double(i) / n, double(j) / n, double(n - i - j) / n});
  return points;
}

/// The same element with its corners renamed 1 -> 2 -> 3 -> 1.
Net turned(int degree, const Net& net) {
  const NetLayout& layout = NetLayout::of(degree);
  Net result(net.size());
  for (int n = 0; n < layout.size(); ++n) {
    const auto [i, j, k] = layout.exponents(n);
    result[std::size_t(layout.index(k, i))] = net[std::size_t(n)];
  }
  return result;
}

}  // namespace

TEST_CASE("on straight triangles the curved shape is tau of the triangle and the distortion is one", "[quality]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  CAPTURE(degree);
  const Point a{0, 0}, b{1, 0};
  const auto [c, tau] = GENERATE(std::pair<Point, double>{{0.5, std::numbers::sqrt3 / 2}, 1.0},
                                 std::pair<Point, double>{{0, 1}, std::numbers::sqrt3 / 2},
                                 std::pair<Point, double>{{0.5, 0.01}, 4 * std::numbers::sqrt3 * 0.005 / 1.5002},
                                 std::pair<Point, double>{{0, -1}, -std::numbers::sqrt3 / 2});
  const Net net = affine_net(degree, a, b, c);
  CHECK(curved_shape(degree, net) == Approx(tau).margin(1e-12));
  CHECK(curved_shape(degree, net) <= triangle_shape(a, b, c) + 1e-16);
  CHECK(shape_at(degree, net, {0.2, 0.5, 0.3}) == Approx(tau).margin(1e-14));
  CHECK(control_shape(degree, net) == Approx(tau).margin(1e-12));
  CHECK(scaled_jacobian(degree, net) == Approx(tau > 0 ? 1 : -1).margin(2e-3));
  if (tau > 0) {
    CHECK(distortion(degree, net) == Approx(1).margin(1e-14));
    CHECK(jacobian_peak(degree, net) == Approx(1).margin(1e-13));
    CHECK(curvature_excess(degree, net, {}) == Approx(0.5));
  } else {
    CHECK(std::isnan(distortion(degree, net)));
    CHECK(std::isnan(jacobian_peak(degree, net)));
    CHECK(curvature_excess(degree, net, {}) == Approx(tangled_excess * (1 - tau)));
  }
}

TEST_CASE("bending that keeps area has distortion exactly one, but not the shape of the straight triangle",
          "[quality]") {
  // The map (x, y + 3 x^2) of the unit right triangle: control points of degree 2 by blossoming x^2.
  const Net net{{0, 0}, {1, 3}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
  CHECK(distortion(2, net) == 1);
  CHECK(jacobian_peak(2, net) == 1);
  CHECK(scaled_jacobian(2, net) == Approx(1).margin(1e-3));
  // T is [[1, 0], [6 x, 1]] times the T of the straight triangle; tau = 2 sqrt(3) / (|a|^2 + |b|^2 + |b - a|^2).
  const double worst = 2 * std::numbers::sqrt3 / (37 + 1 + 26);  // at x = 1: a = (1, 6), b = (0, 1)
  CHECK(curved_shape(2, net) <= worst);
  CHECK(curved_shape(2, net) >= 0.99 * worst);
  CHECK(curvature_excess(2, net, {}) > 1);
}

TEST_CASE("the curved shape is a lower bound of tau, within one per cent or 1e-6", "[quality][property]") {
  const int degree = GENERATE(range(1, 5));
  const double noise = GENERATE(0.01, 0.1, 0.4);
  const std::uint64_t seed = GENERATE(range<std::uint64_t>(0, 40));
  CAPTURE(degree, noise, seed);
  std::mt19937_64 random(seed);
  const Net net = random_net(degree, noise, random);
  Barycentric worst{};
  double sampled = 2;
  const auto sample = [&](const Barycentric& xi) {
    if (const double tau = shape_at(degree, net, xi); tau < sampled) sampled = tau, worst = xi;
  };
  for (const Barycentric& xi : lattice(60)) sample(xi);
  for (double step = 0.02; step > 1e-6; step *= 0.7) {  // descend from the best sample
    const Barycentric centre = worst;
    for (int k = 0; k < 12; ++k) {
      const double u = step * std::cos(k * std::numbers::pi / 6), v = step * std::sin(k * std::numbers::pi / 6);
      const double second = std::clamp(centre[1] + u, 0.0, 1.0), third = std::clamp(centre[2] + v, 0.0, 1 - second);
      sample({1 - second - third, second, third});
    }
  }
  const double bound = curved_shape(degree, net);
  CHECK(bound <= sampled + 1e-14);
  CHECK(bound >= sampled - std::max(0.0101 * std::fabs(sampled), 1.01e-6));
}

TEST_CASE("the distortion is the second moment of det J over its mean", "[quality][property]") {
  const int degree = GENERATE(range(1, 6));
  const std::uint64_t seed = GENERATE(range<std::uint64_t>(0, 20));
  CAPTURE(degree, seed);
  std::mt19937_64 random(seed);
  const Net net = random_net(degree, 0.1, random);
  double square = 0;
  for (const TriangleNode& node : triangle_rule(4 * (degree - 1)))
    square += node.weight * std::pow(jacobian_at(degree, net, node.xi), 2);
  const double area = element_area(degree, net);
  REQUIRE(area > 0);
  CHECK(distortion(degree, net) == Approx(square / (2 * area * area)).epsilon(1e-12));
  CHECK(distortion(degree, net) >= 1);
}

TEST_CASE("measures of an element do not depend on its place, its size, its rotation and the order of its corners",
          "[quality][property]") {
  const int degree = GENERATE(range(1, 5));
  const std::uint64_t seed = GENERATE(range<std::uint64_t>(0, 20));
  CAPTURE(degree, seed);
  std::mt19937_64 random(seed);
  const Net net = random_net(degree, 0.08, random);
  const double cosine = std::cos(0.7), sine = std::sin(0.7);
  Net moved = net;
  for (Point& p : moved) p = Point{cosine * p.x - sine * p.y, sine * p.x + cosine * p.y} * 37.5 + Point{3, -4};
  Net tiny = net, huge = net;
  for (Point& p : tiny) p *= 0x1p-600;
  for (Point& p : huge) p *= 0x1p600;
  for (const Net& other : {moved, turned(degree, net), turned(degree, turned(degree, net))}) {
    CHECK(distortion(degree, other) == Approx(distortion(degree, net)).epsilon(1e-11));
    CHECK(jacobian_peak(degree, other) == Approx(jacobian_peak(degree, net)).epsilon(1e-11));
    CHECK(control_shape(degree, other) == Approx(control_shape(degree, net)).epsilon(1e-10).margin(1e-11));
    CHECK(curved_shape(degree, other) == Approx(curved_shape(degree, net)).epsilon(0.0101).margin(1e-6));
    CHECK(scaled_jacobian(degree, other) == Approx(scaled_jacobian(degree, net)).margin(4e-3));
    CHECK(curvature_excess(degree, other, {}) == Approx(curvature_excess(degree, net, {})).epsilon(0.0102));
  }
  for (const Net& other : {tiny, huge}) {
    CHECK(distortion(degree, other) == distortion(degree, net));
    CHECK(curved_shape(degree, other) == curved_shape(degree, net));
    CHECK(scaled_jacobian(degree, other) == scaled_jacobian(degree, net));
  }
}

TEST_CASE("scaled Jacobians are at most the ratio of any two samples of det J", "[quality][property]") {
  const int degree = GENERATE(range(2, 5));
  const std::uint64_t seed = GENERATE(range<std::uint64_t>(0, 30));
  CAPTURE(degree, seed);
  std::mt19937_64 random(seed);
  const Net net = random_net(degree, 0.2, random);
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  for (const Barycentric& xi : lattice(30)) {
    const double value = jacobian_at(degree, net, xi);
    least = std::min(least, value), greatest = std::max(greatest, value);
  }
  const double scaled = scaled_jacobian(degree, net);
  CHECK(scaled <= least / std::max(std::fabs(least), std::fabs(greatest)) + 1e-3);
  CHECK(scaled >= -1);
}

TEST_CASE("measures of broken elements are defined", "[quality]") {
  const Net point(6, Point{2, 3});
  CHECK(curved_shape(2, point) == 0);
  CHECK(std::isnan(distortion(2, point)));
  CHECK(scaled_jacobian(2, point) == 0);
  Net far = affine_net(2, {-1.7e308, 0}, {1.7e308, 0}, {0, 1});
  CHECK(std::isnan(distortion(2, far)));
  CHECK(curvature_excess(2, far, {}) == HUGE_VAL);
  // A cusp at corner 1: both edges leave in the same direction, det J is zero there and nowhere else.
  const Net cusp{{0, 0}, {1, 0}, {1, 1}, {0.5, 0}, {1, 0.5}, {0.5, 0}};
  CHECK(curved_shape(2, cusp) <= 0);
  CHECK(curved_shape(2, cusp) >= -1e-5);
}
