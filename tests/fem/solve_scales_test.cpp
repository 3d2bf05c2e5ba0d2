// tests/fem/solve_scales_test.cpp: systems far from 1, with rows far from each other, and with jumps of coefficients.
#include <catch2/catch.hpp>

#include "solve_matrices.h"

using namespace pliant;
using namespace pliant::samples;

TEST_CASE("a system and its right-hand side may be of any size; powers of two change no digit", "[fem]") {
  const Mesh mesh = curved_cell(2, 0.02);
  const CsrMatrix a = poisson(mesh);
  const std::vector<double> b = random_values(a.rows(), 3);
  for (const auto& solver : all_solvers(mesh)) {
    CAPTURE(solver->name());
    REQUIRE(solver->factor(a).empty());
    std::vector<double> expected(b.size(), 0);
    REQUIRE(solver->solve(b, expected, solver_tolerance).converged);
    for (const int exponent : {-500, 498}) {  // 1e-150, 1e150
      for (const int right : {-500, 0, 498}) {
        if (std::abs(right - exponent) > 900) continue;  // the solution would be out of range
        CAPTURE(exponent, right);
        CsrMatrix scaled = a;
        for (double& value : scaled.values) value = std::ldexp(value, exponent);
        std::vector<double> load = b, x(b.size(), 0);
        for (double& value : load) value = std::ldexp(value, right);
        REQUIRE(solver->factor(scaled).empty());
        const SolveOutcome outcome = solver->solve(load, x, solver_tolerance);
        CHECK(outcome.converged);
        CHECK(outcome.residual <= solver_tolerance);
        for (double& value : x) value = std::ldexp(value, exponent - right);
        CHECK(greatest_difference(x, expected) < 1e-10);
      }
    }
  }
}

TEST_CASE("rows of a system may be of sizes from 1e-150 to 1e150", "[fem]") {
  const CsrMatrix a = poisson(curved_cell(2, 0.05));
  const std::vector<double> expected = random_values(a.rows(), 5);
  // S A S, with an exponent that varies from unknown to unknown.
  CsrMatrix scaled = a;
  std::vector<double> scaling;
  for (int i = 0; i < a.rows(); ++i) scaling.push_back(std::ldexp(1.0, (i * 37) % 500 - 250));
  for (int i = 0; i < a.rows(); ++i)
    for (int k = a.pattern->starts[index(i)]; k < a.pattern->starts[index(i) + 1]; ++k)
      scaled.values[index(k)] *= scaling[index(i)] * scaling[index(a.pattern->columns[index(k)])];
  std::vector<double> b = product(a, expected);
  for (std::size_t i = 0; i < b.size(); ++i) b[i] *= scaling[i];
  std::vector<std::unique_ptr<LinearSolver>> solvers;
  solvers.push_back(make_direct_symmetric());
  solvers.push_back(make_direct_general());
  for (const auto& solver : solvers) {
    CAPTURE(solver->name());
    REQUIRE(solver->factor(scaled).empty());
    std::vector<double> x(b.size(), 0);
    const SolveOutcome outcome = solver->solve(b, x, solver_tolerance);
    CHECK(outcome.converged);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] *= scaling[i];
    CHECK(greatest_difference(x, expected) < 1e-9);
  }
}

TEST_CASE("coefficients that jump by 1e8 are no obstacle", "[fem]") {
  const Mesh mesh = curved_cell(2, 0.005);
  std::vector<double> diffusivity;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    const Point& corner = mesh.point(mesh.corner(t, 0));
    diffusivity.push_back(length(corner) < 0.5 ? 1e8 : corner.x > 0.7 ? 1e-4 : 1);
  }
  const CsrMatrix a = poisson(mesh, diffusivity);
  const std::vector<double> expected = random_values(a.rows(), 9), b = product(a, expected);
  for (const auto& solver : all_solvers(mesh)) {
    CAPTURE(solver->name());
    REQUIRE(solver->factor(a).empty());
    std::vector<double> x(b.size(), 0);
    const SolveOutcome outcome = solver->solve(b, x, solver_tolerance);
    CAPTURE(outcome.why);
    CHECK(outcome.converged);
    CHECK(residual_of(a, b, x) <= std::max(solver_tolerance, outcome.rounding) * 1.1);
  }
}
