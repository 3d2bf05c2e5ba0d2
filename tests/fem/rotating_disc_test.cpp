// tests/fem/rotating_disc_test.cpp: heat in a rotating disc, a closed form with Bessel's functions.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "fem/diffusion_problems.h"
#include "pliant/flow/advect.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/improve/refine.h"
#include "support/sample_boundaries.h"

using namespace pliant;
using namespace pliant::samples;
using Kind = DiffusionCondition::Kind;

namespace {

constexpr double root = 3.8317059702075125;  // the first positive zero of J1

/// J1(root r) cos(theta - t) exp(-k root^2 t), with k = 0.05: zero on the rim, turning with the disc.
constexpr double conductivity = 0.05;
double mode(double x, double y, double t) {
  const double r = std::hypot(x, y);
  return std::cyl_bessel_j(1.0, root * r) * std::cos(std::atan2(y, x) - t) * std::exp(-conductivity * root * root * t);
}

/// A disc whose rim interpolates the unit circle (at the Greville abscissae), or has straight sides with corners on it.
BoundaryComplex disc(int degree, int spans, bool straight) {
  BoundaryComplex boundary = with_faces({"disc"});
  BSpline rim = circle(degree, {0, 0}, 1, spans);
  const auto on_circle = [&](double t) {
    const double angle = 2 * std::numbers::pi * (t - rim.first_parameter()) / rim.period();
    return Point{std::cos(angle), std::sin(angle)};
  };
  if (straight) {
    std::vector<double> knots;
    std::vector<Point> points;
    for (int s = 0; s < spans; ++s)
      for (int k = 0; k < degree; ++k) {
        knots.push_back(s);
        const double part = static_cast<double>(k) / degree, a = 2 * std::numbers::pi * s / spans;
        const double b = 2 * std::numbers::pi * (s + 1) / spans;
        points.push_back((1 - part) * Point{std::cos(a), std::sin(a)} + part * Point{std::cos(b), std::sin(b)});
      }
    knots.push_back(spans);
    // On a closed curve basis function i starts at knot i: with all knots of multiplicity p the first point is the one
    // that the first knot's last copy belongs to.
    std::rotate(points.begin(), points.begin() + 1, points.end());
    rim = BSpline(degree, true, knots, points);
  } else {
    std::vector<Point> values;
    for (const double t : rim.greville()) values.push_back(on_circle(t));
    REQUIRE(rim.interpolate(values));
  }
  boundary.curves.push_back(closed_curve("rim", rim, 0));
  return boundary;
}

struct Result {
  double error;
  int triangles;
};

Result solve(int degree, int spans, bool straight, int steps) {
  Mesh mesh;
  GenerateOptions first;
  first.degree = degree;
  REQUIRE(mesh_from_boundary(disc(degree, spans, straight), first, mesh).ok);
  mesh.criteria.max_area = 12.0 / (spans * spans);
  refine(mesh, {});
  DiffusionProblem problem = plain_problem(mesh.boundary());
  problem.materials[0].diffusivity = {Coefficient(conductivity)};
  problem.initial[0] = coefficient(mode);
  add_condition(problem, mesh.boundary(), "rim", Kind::value, Coefficient(0));
  Diffusion diffusion(problem, mesh, {});
  const VelocityField turn = [](const Point& p, double) { return Vector{-p.y, p.x}; };
  for (int k = 0; k < steps; ++k) {
    const std::vector<Point> from(mesh.points().begin(), mesh.points().end());
    const double before = mesh.time;
    AdvectOptions options;
    options.dt = 0.5 / steps;
    REQUIRE(advect(mesh, turn, options).status == AdvectOutcome::Status::done);
    diffusion.step(from, before);
  }
  return {errors_of(mesh, {mode, {}, {}}).l2, mesh.triangle_count()};
}

}  // namespace

TEST_CASE("heat in a rotating disc: curved cubic elements are a hundred times better than straight ones",
          "[fem][oracle]") {
  const Result curved = solve(3, 24, false, 400), straight = solve(3, 24, true, 400);
  CAPTURE(curved.error, curved.triangles, straight.error, straight.triangles);
  CHECK(std::abs(curved.triangles - straight.triangles) < curved.triangles / 4);
  CHECK(curved.error * 100 < straight.error);
}

TEST_CASE("heat in a rotating disc: quadratic elements, too, are better curved", "[fem][oracle]") {
  const Result curved = solve(2, 24, false, 100), straight = solve(2, 24, true, 100);
  CAPTURE(curved.error, curved.triangles, straight.error, straight.triangles);
  CHECK(curved.error * 5 < straight.error);
}
