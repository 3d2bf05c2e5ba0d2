// tests/fem/solve_gmres_test.cpp: GMRES with the factors of another matrix.
#include <catch2/catch.hpp>
#include <limits>

#include "pliant/fem/solve/gmres.h"
#include "solve_matrices.h"

using namespace pliant;
using namespace pliant::samples;
using Catch::Matchers::Contains;

namespace {

/// A with every entry changed at random by at most this share of it: not symmetric any more.
CsrMatrix disturbed(const CsrMatrix& a, double share, unsigned seed) {
  CsrMatrix result = a;
  const std::vector<double> noise = random_values(static_cast<int>(a.values.size()), seed);
  for (std::size_t k = 0; k < noise.size(); ++k) result.values[k] *= 1 + 2 * share * noise[k];
  return result;
}

struct System {
  CsrMatrix a;
  std::vector<double> expected, b, x;
};
System make_system(CsrMatrix a, unsigned seed) {
  System system{std::move(a), {}, {}, {}};
  system.expected = random_values(system.a.rows(), seed);
  system.b = product(system.a, system.expected);
  system.x.assign(system.b.size(), 0);
  return system;
}

}  // namespace

TEST_CASE("GMRES solves a matrix with the factors of one near by, in fewer iterations the nearer", "[fem]") {
  const int p = GENERATE(1, 2, 3);
  const Mesh mesh = curved_cell(p, 0.03);
  const CsrMatrix a = heat(mesh, 0.01);
  for (const auto& make : {make_direct_symmetric, make_direct_general}) {
    const auto factors = make();
    REQUIRE(factors->factor(a).empty());
    CAPTURE(p, factors->name());
    int before = 0;
    for (const double share : {0.0, 1e-6, 1e-2, 0.1}) {
      CAPTURE(share);
      System system = make_system(disturbed(a, share, 31), 33);
      const SolveOutcome outcome = solve_by_gmres(system.a, *factors, system.b, system.x);
      CAPTURE(outcome.residual, outcome.iterations, outcome.why);
      CHECK(outcome.converged);
      CHECK(outcome.residual <= solver_tolerance);
      CHECK(residual_of(system.a, system.b, system.x) <= 1.1 * solver_tolerance);
      CHECK(greatest_difference(system.x, system.expected) < 1e-7);
      CHECK(outcome.iterations >= before);
      CHECK(outcome.iterations <= (share == 0 ? 2 : 40));
      before = outcome.iterations;
    }
  }
}

TEST_CASE("any solver preconditions GMRES, also one that iterates itself", "[fem]") {
  const Mesh mesh = curved_cell(2, 0.02);
  const CsrMatrix a = poisson(mesh);
  System system = make_system(disturbed(a, 0.02, 3), 5);
  for (const auto& preconditioner : all_solvers(mesh)) {
    CAPTURE(preconditioner->name());
    REQUIRE(preconditioner->factor(a).empty());
    std::vector<double> x(system.b.size(), 0), again = x;
    const SolveOutcome outcome = solve_by_gmres(system.a, *preconditioner, system.b, x);
    CAPTURE(outcome.residual, outcome.iterations, outcome.why);
    CHECK(outcome.converged);
    CHECK(greatest_difference(x, system.expected) < 1e-6);
    CHECK(outcome.iterations < 60);
    solve_by_gmres(system.a, *preconditioner, system.b, again);
    CHECK(again == x);
  }
}

TEST_CASE("GMRES solves with convection by the factors of a symmetric part", "[fem]") {
  const Mesh mesh = curved_cell(2, 0.01);
  const CsrMatrix symmetric = heat(mesh, 0.01);
  CsrMatrix a = symmetric;  // a skew part, as convection has
  for (int i = 0; i < a.rows(); ++i)
    for (int k = a.pattern->starts[index(i)]; k < a.pattern->starts[index(i) + 1]; ++k)
      if (const int j = a.pattern->columns[index(k)]; j != i)
        a.values[index(k)] += (j > i ? 0.5 : -0.5) * std::abs(symmetric.values[index(k)]);
  System system = make_system(a, 8);
  const auto factors = make_direct_symmetric();
  REQUIRE(factors->factor(symmetric).empty());
  const SolveOutcome outcome = solve_by_gmres(a, *factors, system.b, system.x);
  CAPTURE(outcome.residual, outcome.iterations, outcome.why);
  CHECK(outcome.converged);
  CHECK(greatest_difference(system.x, system.expected) < 1e-8);

  SECTION("a cycle that ends early only costs iterations") {
    std::vector<double> x(system.b.size(), 0);
    const SolveOutcome short_cycles = solve_by_gmres(a, *factors, system.b, x, {.restart = 8});
    CHECK(short_cycles.converged);
    CHECK(short_cycles.iterations >= outcome.iterations);
    CHECK(short_cycles.refinements > 0);
    CHECK(greatest_difference(x, system.expected) < 1e-8);
  }
  SECTION("a good guess saves iterations, and a solution needs none") {
    std::vector<double> x = system.x;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] *= 1 + 1e-7 * std::sin(static_cast<double>(k));
    const SolveOutcome from_guess = solve_by_gmres(a, *factors, system.b, x);
    CHECK(from_guess.converged);
    CHECK(from_guess.iterations < outcome.iterations);
    const SolveOutcome none_left = solve_by_gmres(a, *factors, system.b, x);
    CHECK(none_left.converged);
    CHECK(none_left.iterations == 0);
  }
  SECTION("too few iterations are said, with the residual that is left") {
    std::vector<double> x(system.b.size(), 0);
    const SolveOutcome stopped = solve_by_gmres(a, *factors, system.b, x, {.most_iterations = 3});
    CHECK_FALSE(stopped.converged);
    CHECK(stopped.iterations == 3);
    CHECK(stopped.residual == Approx(residual_of(a, system.b, x)));
    CHECK(stopped.residual < 1);
    CHECK_THAT(stopped.why, Contains("after 3 iterations") && Contains("GMRES"));
  }
}

TEST_CASE("GMRES does not need the matrix of a direct preconditioner any more", "[fem]") {
  const Mesh mesh = curved_cell(2, 0.1);
  System system = make_system(poisson(mesh), 2);
  for (const auto& make : {make_direct_symmetric, make_direct_general}) {
    const auto factors = make();
    {
      const auto other = std::make_unique<CsrMatrix>(poisson(mesh));
      REQUIRE(factors->factor(*other).empty());
      std::ranges::fill(other->values, std::numeric_limits<double>::quiet_NaN());
    }
    std::vector<double> x(system.b.size(), 0);
    CHECK(solve_by_gmres(system.a, *factors, system.b, x).converged);
  }
}

TEST_CASE("GMRES refuses what is not finite, and says so of a singular matrix", "[fem]") {
  const CsrMatrix a = from_rows({{4, 1, 0}, {1, 3, 1}, {0, 1, 5}});
  const auto factors = make_direct_symmetric();
  REQUIRE(factors->factor(a).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x{0, 0, 0};
  CsrMatrix broken = a;
  broken.values[0] = nan;
  CHECK_THAT(solve_by_gmres(broken, *factors, std::vector<double>{1, 2, 3}, x).why, Contains("row 0, column 0"));
  CHECK_THAT(solve_by_gmres(a, *factors, std::vector<double>{1, nan, 3}, x).why, Contains("right-hand side"));
  std::vector<double> wrong{0, 0, nan};
  CHECK_THAT(solve_by_gmres(a, *factors, std::vector<double>{1, 2, 3}, wrong).why, Contains("guess"));

  const CsrMatrix singular = from_rows({{1, 1, 0}, {1, 1, 0}, {0, 0, 1}});
  const SolveOutcome inconsistent = solve_by_gmres(singular, *factors, std::vector<double>{1, 0, 1}, x);
  CHECK_FALSE(inconsistent.converged);
  CHECK_FALSE(inconsistent.why.empty());
  const SolveOutcome consistent = solve_by_gmres(singular, *factors, std::vector<double>{2, 2, 1}, x);
  CAPTURE(consistent.why);
  CHECK(consistent.converged);

  const SolveOutcome zero = solve_by_gmres(a, *factors, std::vector<double>{0, 0, 0}, x);
  CHECK(zero.converged);
  CHECK(x == std::vector<double>{0, 0, 0});
}

TEST_CASE("GMRES solves systems far from 1 in size", "[fem]") {
  const Mesh mesh = curved_cell(2, 0.1);
  for (const double unit : {1e-140, 1e140}) {
    CAPTURE(unit);
    CsrMatrix a = poisson(mesh);
    for (double& each : a.values) each *= unit;
    const auto factors = make_direct_general();
    REQUIRE(factors->factor(a).empty());
    System system = make_system(disturbed(a, 0.01, 4), 6);
    const SolveOutcome outcome = solve_by_gmres(system.a, *factors, system.b, system.x);
    CAPTURE(outcome.residual, outcome.iterations, outcome.why);
    CHECK(outcome.converged);
    CHECK(greatest_difference(system.x, system.expected) < 1e-8);
  }
}
