// tests/flow/named_flows_test.cpp: named flows are finite and free of divergence, and have their known properties.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "pliant/flow/runge_kutta.h"
#include "pliant/flow/velocity_field.h"

using namespace pliant;

namespace {

std::vector<Point> random_points(unsigned seed, int count, double range) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-range, range);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double x = coordinate(random);
    points.push_back({x, coordinate(random)});
  }
  return points;
}

double divergence(const VelocityField& v, const Point& x, double t) {
  const double h = 1e-5;
  return (v(x + Vector{h, 0}, t).x - v(x - Vector{h, 0}, t).x + v(x + Vector{0, h}, t).y - v(x - Vector{0, h}, t).y) /
         (2 * h);
}

}  // namespace

TEST_CASE("every named flow is finite everywhere and free of divergence outside a source", "[flow]") {
  for (const NamedFlow& flow : named_flows()) {
    CAPTURE(flow.name);
    CHECK_FALSE(flow.description.empty());
    const VelocityField v = make_flow(flow.name, {});
    for (const Point& x : random_points(1, 400, 3)) {
      CAPTURE(x.x, x.y);
      CHECK(is_finite(v(x, 0.3)));
      if (flow.name != "source" || length(x) > 0.11) CHECK(std::abs(divergence(v, x, 0.3)) < 1e-6);
    }
    CHECK(is_finite(v({0, 0}, 0)));
    CHECK(is_finite(v({1, 0}, 0)));
    for (const NamedFlow::Parameter& parameter : flow.parameters)
      CHECK_NOTHROW(make_flow(flow.name, {{parameter.name, parameter.value}}));
  }
}

TEST_CASE("the flow past a cylinder is tangent to it, continuous across it and uniform far away", "[flow]") {
  const Point centre{0.5, -0.25};
  const VelocityField v =
      make_flow("cylinder", {{"radius", 0.75}, {"speed", 2}, {"x", 0.5}, {"y", -0.25}, {"circulation", 3}});
  for (int i = 0; i < 64; ++i) {
    const Vector outward{std::cos(0.1 * i), std::sin(0.1 * i)};
    CHECK(std::abs(dot(v(centre + 0.75 * outward, 0), outward)) < 1e-14);
    CHECK(length(v(centre + (0.75 + 1e-9) * outward, 0) - v(centre + (0.75 - 1e-9) * outward, 0)) < 1e-7);
    CHECK(length(v(centre + 1e6 * outward, 0) - Vector{2, 0}) < 1e-6);
  }
  // The velocity is twice the speed at the side of the cylinder, and 0 in front of it.
  const VelocityField plain = make_flow("cylinder", {});
  CHECK(length(plain({0, 1}, 0) - Vector{2, 0}) < 1e-15);
  CHECK(length(plain({-1, 0}, 0)) < 1e-15);
}

TEST_CASE("the stream function of the cylinder is kept along a path", "[flow]") {
  const VelocityField v = make_flow("cylinder", {});
  const auto psi = [](const Point& x) { return x.y * (1 - 1 / squared_length(x)); };
  for (const double y : {0.05, 0.2, 1.0}) {
    const Point start{-4, y};
    const Point end = start + carry(v, start, 0, 10, 4000);
    CHECK(end.x > 2);
    CHECK(psi(end) == Approx(psi(start)).epsilon(1e-9));
  }
}

TEST_CASE("the reversed vortex returns every point after its period", "[flow]") {
  const VelocityField v = make_flow(GENERATE("reversed-vortex", "vortex"), {{"period", 3}});
  for (const Point& x : random_points(2, 20, 0.5)) {
    const Point start = x + Point{0.5, 0.5};
    CHECK(length(carry(v, start, 0, 3, 400)) < 1e-8);
    CHECK(length(carry(v, start, 0, 1.5, 200)) > 1e-6);
  }
}

TEST_CASE("the vortices have their circulation", "[flow]") {
  for (const char* name : {"rankine", "lamb-oseen"}) {
    const VelocityField v = make_flow(name, {{"circulation", 2.5}, {"core", 0.2}});
    double circulation = 0;
    for (int i = 0; i < 100; ++i) {
      const Vector outward{std::cos(2 * std::numbers::pi * i / 100), std::sin(2 * std::numbers::pi * i / 100)};
      circulation += dot(v(2 * outward, 0), perpendicular(outward)) * 2 * std::numbers::pi * 2 / 100;
    }
    CHECK(circulation == Approx(2.5).epsilon(1e-10));
  }
}

TEST_CASE("wrong names and parameters of flows are refused with the names that there are", "[flow]") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(make_flow("whirl", {}), Contains("whirl") && Contains("taylor-green"));
  CHECK_THROWS_WITH(make_flow("cylinder", {{"r", 1}}), Contains("\"r\"") && Contains("circulation"));
  CHECK_THROWS_WITH(make_flow("cylinder", {{"radius", 0}}), Contains("radius must be greater than 0"));
  CHECK_THROWS_WITH(make_flow("uniform", {{"u", std::nan("")}}), Contains("u must be finite"));
  CHECK_THROWS_WITH(make_flow("channel", {{"top", -1}}), Contains("top must be greater than bottom"));
}
