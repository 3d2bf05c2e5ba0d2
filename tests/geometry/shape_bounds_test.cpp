// tests/geometry/shape_bounds_test.cpp: the least shape of an element is between its bounds, and `worst` attains it.
#include "pliant/geometry/placement/shape_bounds.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/linear_triangle.h"

namespace {
using namespace pliant;

double tau_at(int degree, const std::vector<Point>& net, const Barycentric& xi) {
  std::vector<double> rows;
  for (const Point& p : net) rows.insert(rows.end(), {p.x, p.y});
  std::vector<double> value(2), u(2), v(2);
  evaluate_net(degree, 2, rows, xi, value, u, v);
  // A small equilateral triangle has the edges u, and -u/2 plus or minus sqrt(3)/2 times the other column, in the
  // image.
  return triangle_shape({0, 0}, {u[0], u[1]}, {v[0], v[1]});
}

std::vector<Point> random_net(int degree, unsigned seed, double noise) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Point> net;
  const NetLayout& layout = NetLayout::of(degree);
  for (int n = 0; n < layout.size(); ++n) {
    const auto& [i, j, k] = layout.exponents(n);
    net.push_back(Point{double(j) / degree, double(k) / degree} + noise / degree * Point{unit(random), unit(random)});
  }
  return net;
}

}  // namespace

TEST_CASE("the least shape is between its bounds, and the worst point attains the upper one", "[geometry][property]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  for (unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(degree, seed);
    const auto net = random_net(degree, seed, 0.1 * (seed % 10));
    const ShapeBounds bounds = least_shape(degree, net, 1e-3);
    CHECK(bounds.lower <= bounds.upper);
    CHECK(bounds.upper == Approx(tau_at(degree, net, bounds.worst)).margin(1e-10));
    if (bounds.lower > 0.01) CHECK(bounds.upper - bounds.lower <= 1.001e-3 * bounds.upper + 1e-6);
    double sampled = 1;
    const int steps = 30;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j)
        sampled = std::min(sampled, tau_at(degree, net, {i / 30.0, j / 30.0, (steps - i - j) / 30.0}));
    CHECK(sampled >= bounds.lower - 1e-12);
    if (bounds.lower > 0.01) CHECK(bounds.upper <= sampled * (1 + 1e-3) + 1e-6);
  }
}

TEST_CASE("a straight element has the shape of its triangle, at any size", "[geometry]") {
  const double unit = GENERATE(1.0, 1e-160, 1e160);
  auto net = random_net(1, 3, 0.4);
  const double tau = triangle_shape(net[0], net[1], net[2]);
  for (Point& p : net) p *= unit;
  const ShapeBounds bounds = least_shape(1, net);
  CHECK(bounds.lower == Approx(tau));
  CHECK(bounds.upper == Approx(tau));
}
