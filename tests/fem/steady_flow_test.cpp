// tests/fem/steady_flow_test.cpp: steady flows against exact ones.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "flows.h"
#include "support/mapped_meshes.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

constexpr double reynolds = 20;
const double lambda = reynolds / 2 - std::sqrt(reynolds * reynolds / 4 + 4 * std::numbers::pi * std::numbers::pi);

/// Kovasznay's flow: an exact solution with convection.
double kovasznay_x(const Point& x, double) { return 1 - std::exp(lambda * x.x) * std::cos(2 * std::numbers::pi * x.y); }
double kovasznay_y(const Point& x, double) {
  return lambda / (2 * std::numbers::pi) * std::exp(lambda * x.x) * std::sin(2 * std::numbers::pi * x.y);
}

}  // namespace

TEST_CASE("a parallel flow comes out exactly, with and without convection, in both forms", "[navier_stokes]") {
  const int degree = GENERATE(2, 3, 4);
  const bool stress = GENERATE(false, true);
  Mesh mesh(mapped_square(degree, 3, as_it_is));
  FlowProblem problem = flow_problem(mesh, 1, 0.1);
  const auto profile = [](const Point& x, double) { return 4 * x.y * (1 - x.y); };
  set_velocity(problem, mesh, {"west"}, profile, zero);
  set_velocity(problem, mesh, {"south", "north"}, zero, zero);
  set_condition(problem, mesh, "east", {FlowCondition::Kind::outflow, Coefficient(0), Coefficient(0), ""});
  if (stress) problem.materials[0].viscosity = coefficient([](const Point&, double) { return 0.1; });
  NavierStokes flow(problem, mesh, {.by_splines = false});
  CHECK(flow.equation().form().is_stress == stress);
  flow.solve_steady();
  CHECK(error_of(mesh, "velocity", 0, profile) < 1e-11);
  CHECK(error_of(mesh, "velocity", 1, zero) < 1e-11);
  CHECK(error_of(mesh, "pressure", 0, [](const Point& x, double) { return 0.8 * (1 - x.x); }) < 1e-10);
  // Each wall is drawn along by viscosity * du/dy = 0.4 over its length, and pressed by the integral of the pressure.
  CHECK(flow.forces().at("south").x == Approx(0.4).epsilon(1e-9));
  CHECK(flow.forces().at("north").x == Approx(0.4).epsilon(1e-9));
}

TEST_CASE("Kovasznay's flow converges with order p + 1, its pressure with order p, on curved meshes",
          "[navier_stokes]") {
  const int degree = GENERATE(2, 3);
  std::vector<double> velocity, pressure;
  for (const int n : {6, 12}) {
    Mesh mesh(mapped_square(degree, n, bend));
    FlowProblem problem = flow_problem(mesh, 1, 1 / reynolds);
    set_velocity(problem, mesh, square_sides, kovasznay_x, kovasznay_y);
    NavierStokes flow(problem, mesh, {.by_splines = false});
    flow.solve_steady();
    velocity.push_back(error_of(mesh, "velocity", 0, kovasznay_x));
    double mean = 0;  // the exact pressure is known up to a constant
    const auto exact = [&mean](const Point& x, double) { return 0.5 * (1 - std::exp(2 * lambda * x.x)) - mean; };
    const double at_0 = error_of(mesh, "pressure", 0, exact);
    mean = 1;
    const double at_1 = error_of(mesh, "pressure", 0, exact);
    mean = 2;
    const double at_2 = error_of(mesh, "pressure", 0, exact);
    // The square of the error is a parabola in the constant; its least value is the error.
    const double a = (at_2 * at_2 - 2 * at_1 * at_1 + at_0 * at_0) / 2, b = at_1 * at_1 - at_0 * at_0 - a;
    mean = -b / (2 * a);
    pressure.push_back(error_of(mesh, "pressure", 0, exact));
  }
  INFO("p " << degree << " velocity " << velocity[0] << " " << velocity[1] << " pressure " << pressure[0] << " "
            << pressure[1]);
  CHECK(std::log2(velocity[0] / velocity[1]) > degree + 0.7);
  CHECK(std::log2(pressure[0] / pressure[1]) > degree - 0.3);
}

TEST_CASE("two layers, one a thousand times as viscous: the parallel flow is exact", "[navier_stokes]") {
  const int degree = GENERATE(2, 3);
  // Layers are left and right of x = 1/2; the flow runs along y.
  Mesh mesh(mapped_square(degree, 4, as_it_is, true));
  const double left = 1, right = 1000;
  FlowProblem problem = flow_problem(mesh, 1, left);
  problem.materials[1].viscosity = Coefficient(right);
  // mu v'' = -1 in each layer: v = -(x^2 - a x) / (2 mu) on the left, and so on; stress is continuous at 1/2.
  // v_l = (a x - x^2) / (2 left), v_r = (b (1 - x) - (1 - x)^2) / (2 right); equal at 1/2, and a - 1 = -(b - 1).
  const double b = (2 - 0.5 + 0.5 * left / right) / (1 + left / right), a = 2 - b;
  const auto profile = [=](const Point& x, double) {
    return x.x <= 0.5 ? (a * x.x - x.x * x.x) / (2 * left) : (b * (1 - x.x) - (1 - x.x) * (1 - x.x)) / (2 * right);
  };
  set_velocity(problem, mesh, {"south"}, zero, profile);
  set_velocity(problem, mesh, {"east", "west"}, zero, zero);
  set_condition(problem, mesh, "north", {FlowCondition::Kind::outflow, Coefficient(0), Coefficient(0), ""});
  NavierStokes flow(problem, mesh, {.by_splines = false});
  flow.solve_steady();
  CHECK(error_of(mesh, "velocity", 1, profile) < 1e-10);
  CHECK(error_of(mesh, "velocity", 0, zero) < 1e-10);
  CHECK(error_of(mesh, "pressure", 0, [](const Point& x, double) { return 1 - x.y; }) < 1e-8);
}

TEST_CASE("factors without pivots solve flows with convection as factors with pivots do", "[navier_stokes]") {
  const int degree = GENERATE(2, 3, 4);
  const double viscosity = GENERATE(1.0, 1e-2, 1e-4);
  Mesh mesh(mapped_square(degree, 5, bend));
  FlowProblem problem = flow_problem(mesh, 1, viscosity);
  set_velocity(problem, mesh, square_sides, kovasznay_x, kovasznay_y);
  const FlowEquation equation(problem, mesh, false);
  const Configuration at{mesh.points(), 0};
  std::vector<double> given(2 * index(mesh.point_slots())), load;
  equation.velocities().give(at, given);
  std::vector<double> wind(given.size());
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    wind[2 * index(p)] = kovasznay_x(mesh.point(p), 0);
    wind[2 * index(p) + 1] = kovasznay_y(mesh.point(p), 0);
  }
  FlowTerms terms;
  terms.convecting = wind;
  CsrMatrix matrix;
  equation.assemble(at, terms, given, matrix, load);
  equation.pin_pressures(matrix, load);
  std::vector<std::vector<double>> solutions;
  for (const auto& solver : {make_saddle_general(equation.multipliers()), make_direct_general()}) {
    CAPTURE(solver->name(), degree, viscosity);
    REQUIRE(solver->factor(matrix).empty());
    std::vector<double> x(load.size(), 0.0);
    const SolveOutcome outcome = solver->solve(load, x, solver_tolerance);
    CAPTURE(outcome.why, outcome.iterations);
    CHECK(outcome.converged);
    CHECK(outcome.residual <= 1e-11);
    solutions.push_back(x);
  }
  double greatest = 0, difference = 0;
  for (std::size_t i = 0; i < load.size(); ++i) {
    greatest = std::max(greatest, std::abs(solutions[1][i]));
    difference = std::max(difference, std::abs(solutions[0][i] - solutions[1][i]));
  }
  CHECK(difference <= 1e-7 * greatest);
}
