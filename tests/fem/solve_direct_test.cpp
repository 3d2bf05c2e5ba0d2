// tests/fem/solve_direct_test.cpp: what all solvers do alike, and what the direct ones find.
#include <catch2/catch.hpp>

#include "solve_matrices.h"

using namespace pliant;
using namespace pliant::samples;

TEST_CASE("every solver finds the solution of Poisson's problem on curved meshes of degrees 1 to 5", "[fem]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const Mesh mesh = curved_cell(degree, 0.02 * degree);
  const CsrMatrix a = poisson(mesh);
  const std::vector<double> expected = random_values(a.rows(), 7), b = product(a, expected);
  std::vector<std::unique_ptr<LinearSolver>> solvers = all_solvers();
  solvers.push_back(make_two_level(hats(mesh)));
  for (const auto& solver : solvers) {
    CAPTURE(degree, a.rows(), solver->name());
    REQUIRE(solver->factor(a).empty());
    std::vector<double> x(b.size(), 0);
    const SolveOutcome outcome = solver->solve(b, x, solver_tolerance);
    CHECK(outcome.converged);
    CHECK(outcome.why.empty());
    CHECK(outcome.residual <= solver_tolerance);
    CHECK(outcome.residual == Approx(residual_of(a, b, x)).epsilon(0.2).margin(1e-15));
    CHECK(greatest_difference(x, expected) < 1e-9);
  }
}

TEST_CASE("systems of no, one and two rows are solved", "[fem]") {
  for (const auto& solver : all_solvers()) {
    CAPTURE(solver->name());
    const CsrMatrix none = from_rows({});
    REQUIRE(solver->factor(none).empty());
    std::vector<double> x;
    CHECK(solver->solve({}, x, solver_tolerance).converged);

    const CsrMatrix one = from_rows({{4}});
    REQUIRE(solver->factor(one).empty());
    x = {0};
    CHECK(solver->solve(std::vector<double>{6}, x, solver_tolerance).converged);
    CHECK(x[0] == Approx(1.5).epsilon(1e-15));

    const CsrMatrix two = from_rows({{2, 1}, {1, 2}});
    REQUIRE(solver->factor(two).empty());
    x = {0, 0};
    CHECK(solver->solve(std::vector<double>{4, 5}, x, solver_tolerance).converged);
    CHECK(x[0] == Approx(1).epsilon(1e-14));
    CHECK(x[1] == Approx(2).epsilon(1e-14));
  }
}

TEST_CASE("the right-hand side 0 has the solution 0, whatever the guess", "[fem]") {
  const CsrMatrix a = from_rows({{2, 1}, {1, 2}});
  for (const auto& solver : all_solvers()) {
    CAPTURE(solver->name());
    REQUIRE(solver->factor(a).empty());
    std::vector<double> x{3, 4};
    const SolveOutcome outcome = solver->solve(std::vector<double>{0, 0}, x, solver_tolerance);
    CHECK(outcome.converged);
    CHECK(outcome.residual == 0);
    CHECK(x == std::vector<double>{0, 0});
  }
}

TEST_CASE("the same system gives the same bits, wherever its numbers lie", "[fem]") {
  const Mesh mesh = curved_cell(2, 0.01);
  const CsrMatrix a = poisson(mesh), copy{std::make_shared<CsrPattern>(*a.pattern), a.values};
  const std::vector<double> b = random_values(a.rows(), 11);
  std::vector<double> moved(3, 0);
  moved.insert(moved.end(), b.begin(), b.end());
  std::vector<std::unique_ptr<LinearSolver>> first = all_solvers(), second = all_solvers();
  first.push_back(make_two_level(hats(mesh)));
  second.push_back(make_two_level(hats(mesh)));
  for (std::size_t s = 0; s < first.size(); ++s) {
    CAPTURE(first[s]->name());
    REQUIRE(first[s]->factor(a).empty());
    REQUIRE(second[s]->factor(copy).empty());
    std::vector<double> x(b.size(), 0), y(b.size() + 1, 0);
    first[s]->solve(b, x, solver_tolerance);
    second[s]->solve(std::span<const double>(moved).subspan(3), std::span<double>(y).subspan(1), solver_tolerance);
    CHECK(std::equal(x.begin(), x.end(), y.begin() + 1));
  }
}

TEST_CASE("a solver can take one matrix after another", "[fem]") {
  const CsrMatrix large = poisson(curved_cell(2, 0.05)), small = from_rows({{4, 1}, {1, 3}});
  for (const auto& solver : all_solvers()) {
    CAPTURE(solver->name());
    for (const CsrMatrix* a : {&large, &small, &large}) {
      REQUIRE(solver->factor(*a).empty());
      const std::vector<double> b = random_values(a->rows(), 5);
      std::vector<double> x(b.size(), 0);
      CHECK(solver->solve(b, x, solver_tolerance).converged);
      CHECK(residual_of(*a, b, x) <= 2 * solver_tolerance);
    }
  }
}

TEST_CASE("a shuffled numbering has the same solution", "[fem]") {
  const Mesh mesh = curved_cell(2, 0.01);
  const CsrMatrix a = poisson(mesh);
  const std::vector<int> order = random_order(a.rows(), 23);
  const CsrMatrix mixed = shuffled(a, order);
  const std::vector<double> expected = random_values(a.rows(), 29), b = product(a, expected);
  std::vector<double> right(b.size());
  for (std::size_t k = 0; k < right.size(); ++k) right[k] = b[index(order[k])];
  for (const auto& solver : all_solvers()) {
    CAPTURE(solver->name());
    REQUIRE(solver->factor(mixed).empty());
    std::vector<double> x(b.size(), 0);
    CHECK(solver->solve(right, x, solver_tolerance).converged);
    double greatest = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
      greatest = std::max(greatest, std::abs(x[k] - expected[index(order[k])]));
    CHECK(greatest < 1e-9);
  }
}

TEST_CASE("LU solves systems that are not symmetric, with pivots off the diagonal", "[fem]") {
  const CsrMatrix small = from_rows({{0, 2, 0}, {1, 0, 3}, {0, 4, 5}});
  const auto solver = make_direct_general();
  REQUIRE(solver->factor(small).empty());
  std::vector<double> x(3);
  CHECK(solver->solve(std::vector<double>{4, 10, 23}, x, solver_tolerance).converged);
  CHECK(greatest_difference(x, {1, 2, 3}) < 1e-13);

  // Convection ten times as strong as diffusion between neighbours.
  CsrMatrix a = poisson(curved_cell(2, 0.01));
  for (int i = 0; i < a.rows(); ++i)
    for (int k = a.pattern->starts[index(i)]; k < a.pattern->starts[index(i) + 1]; ++k)
      if (const int j = a.pattern->columns[index(k)]; a.values[index(k)] != 0 && i != j)
        a.values[index(k)] += i < j ? 5 : -5;
  REQUIRE(solver->factor(a).empty());
  const std::vector<double> b = random_values(a.rows(), 31);
  x.assign(b.size(), 0);
  CHECK(solver->solve(b, x, solver_tolerance).converged);
  CHECK(residual_of(a, b, x) <= 2 * solver_tolerance);
}

TEST_CASE("dense matrices are factored, whose supernodes are wide", "[fem]") {
  const int n = 200;
  std::vector<std::vector<double>> rows(index(n), std::vector<double>(index(n)));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) rows[index(i)][index(j)] = std::min(i, j) + 1;  // its inverse has three diagonals
  const CsrMatrix a = from_rows(rows);
  const std::vector<double> expected = random_values(n, 37), b = product(a, expected);
  for (const auto& solver : all_solvers()) {
    CAPTURE(solver->name());
    REQUIRE(solver->factor(a).empty());
    std::vector<double> x(b.size(), 0);
    CHECK(solver->solve(b, x, solver_tolerance).converged);
    CHECK(greatest_difference(x, expected) < 1e-8);
  }
}
