// tests/fem/solve_refusals_test.cpp: singular and indefinite matrices, numbers that are not finite, what is said of
// them.
#include <catch2/catch.hpp>
#include <limits>

#include "solve_matrices.h"

using namespace pliant;
using namespace pliant::samples;
using Catch::Matchers::Contains;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

/// Why the matrix is refused, by `factor` or by `solve`.
std::string refusal(LinearSolver& solver, const CsrMatrix& a, const std::vector<double>& b) {
  if (std::string why = solver.factor(a); !why.empty()) return why;
  std::vector<double> x(b.size(), 0);
  const SolveOutcome outcome = solver.solve(b, x, solver_tolerance);
  CHECK(outcome.converged == outcome.why.empty());
  for (const double value : x) CHECK(std::isfinite(value));
  return outcome.why;
}

}  // namespace

TEST_CASE("an indefinite matrix is refused by the symmetric solvers, with the row", "[fem]") {
  CsrMatrix a = poisson(curved_cell(2, 0.05));
  const int row = a.rows() / 2;
  a.values[index(a.pattern->find(row, row))] = -3;
  const std::vector<double> b = random_values(a.rows(), 1);
  CHECK_THAT(refusal(*make_conjugate_gradients(), a, b),
             Contains("diagonal entry of row " + std::to_string(row) + " is -3") && Contains("not positive definite"));
  CHECK_THAT(refusal(*make_direct_symmetric(), a, b), Contains("pivot of row") && Contains("not positive definite"));
  CHECK(refusal(*make_direct_general(), a, b).empty());

  // Its diagonal does not tell.
  const CsrMatrix small = from_rows({{1, 0.9, 0.9}, {0.9, 1, -0.9}, {0.9, -0.9, 1}});
  CHECK_THAT(refusal(*make_direct_symmetric(), small, {1, 2, 3}), Contains("not positive definite"));
  CHECK_THAT(refusal(*make_conjugate_gradients(), small, {1, 2, 3}), Contains("not positive definite"));
  const CsrMatrix beyond = from_rows({{1, 2}, {2, 1}});
  CHECK_THAT(refusal(*make_direct_symmetric(), beyond, {1, -2}), Contains("pivot of row") && Contains("-3"));
  CHECK_THAT(refusal(*make_conjugate_gradients(), beyond, {1, -2}), Contains("row 1, column 0"));
}

TEST_CASE("a singular matrix is refused: values that no condition holds, at any degree and size", "[fem]") {
  const int degree = GENERATE(1, 2, 3);
  const double area = GENERATE(0.1, 0.01);
  const CsrMatrix a = mass_and_stiffness(curved_cell(degree, area)).stiffness;
  const std::vector<double> b = random_values(a.rows(), 2);
  CAPTURE(degree, area, a.rows());
  CHECK_THAT(refusal(*make_direct_symmetric(), a, b), Contains("singular"));
  CHECK_THAT(refusal(*make_direct_general(), a, b), Contains("singular"));
  CHECK_FALSE(refusal(*make_conjugate_gradients(), a, b).empty());
}

TEST_CASE("a condition that holds the solution weakly makes no singular matrix", "[fem]") {
  CsrMatrix a = mass_and_stiffness(curved_cell(2, 0.01)).stiffness;
  for (const double hold : {1.0, 1e-3, 1e-6}) {
    CAPTURE(hold);
    CsrMatrix held = a;
    held.values[index(held.pattern->find(0, 0))] += hold;
    const std::vector<double> b = product(held, random_values(a.rows(), 3));
    CHECK(refusal(*make_direct_symmetric(), held, b).empty());
  }
}

TEST_CASE("exactly singular matrices are refused with the row", "[fem]") {
  const CsrMatrix zero = from_rows({{0}});
  const CsrMatrix twice = from_rows({{1, 1}, {1, 1}});
  const CsrMatrix empty_row = from_rows({{1, 0, 0}, {0, 0, 0}, {0, 0, 1}});
  CHECK_THAT(refusal(*make_direct_symmetric(), zero, {1}), Contains("row 0") && Contains("singular"));
  CHECK_THAT(refusal(*make_direct_general(), zero, {1}), Contains("row 0") && Contains("singular"));
  CHECK_THAT(refusal(*make_conjugate_gradients(), zero, {1}), Contains("row 0"));
  CHECK_THAT(refusal(*make_direct_symmetric(), twice, {1, 2}), Contains("singular"));
  CHECK_THAT(refusal(*make_direct_general(), twice, {1, 2}), Contains("singular"));
  CHECK_THAT(refusal(*make_direct_symmetric(), empty_row, {1, 2, 3}), Contains("row 1"));
  CHECK_THAT(refusal(*make_direct_general(), empty_row, {1, 2, 3}), Contains("row 1"));
  CHECK_THAT(refusal(*make_conjugate_gradients(), empty_row, {1, 2, 3}), Contains("row 1"));
}

TEST_CASE("numbers that are not finite are refused with their place", "[fem]") {
  const CsrMatrix a = from_rows({{2, 1}, {1, 2}});
  for (const auto& solver : all_solvers())
    for (const double bad : {not_a_number, infinity, -infinity}) {
      CAPTURE(solver->name(), bad);
      CsrMatrix spoiled = a;
      spoiled.values[2] = bad;
      CHECK_THAT(solver->factor(spoiled), Contains("not finite in row 1, column 0"));
      REQUIRE(solver->factor(a).empty());
      std::vector<double> x{0, 0};
      const SolveOutcome outcome = solver->solve(std::vector<double>{1, bad}, x, solver_tolerance);
      CHECK_FALSE(outcome.converged);
      CHECK_THAT(outcome.why, Contains("right-hand side is not finite in row 1"));
    }
  const auto gradients = make_conjugate_gradients();
  REQUIRE(gradients->factor(a).empty());
  std::vector<double> x{not_a_number, 0};
  CHECK_THAT(gradients->solve(std::vector<double>{1, 1}, x, solver_tolerance).why,
             Contains("guess is not finite in row 0"));
}

TEST_CASE("a matrix that is not symmetric is noticed by its residual", "[fem]") {
  const CsrMatrix a = from_rows({{2, -1.5, 0}, {1.5, 2, -1}, {0, 1, 2}});
  CHECK_THAT(refusal(*make_direct_symmetric(), a, {1, 2, 3}), Contains("residual stays at"));
  CHECK_THAT(refusal(*make_conjugate_gradients(), a, {1, 2, 3}), Contains("residual stays at"));
  CHECK(refusal(*make_direct_general(), a, {1, 2, 3}).empty());
}

TEST_CASE("where rounding leaves more than the tolerance, the outcome says how much", "[fem]") {
  // A smooth load on a fine mesh: |A||x| is 1e5 times as large as b.
  const Mesh mesh = curved_cell(2, 0.0006);
  const MassAndStiffness both = mass_and_stiffness(mesh);
  CsrMatrix a = both.stiffness;
  const std::vector<bool> fixed = on_curves(mesh);
  fix(a, fixed);
  std::vector<double> b = product(both.mass, std::vector<double>(fixed.size(), 1));
  for (std::size_t i = 0; i < b.size(); ++i)
    if (fixed[i]) b[i] = 0;
  for (const auto& solver : all_solvers(mesh)) {
    CAPTURE(solver->name());
    REQUIRE(solver->factor(a).empty());
    std::vector<double> x(b.size(), 0);
    const SolveOutcome outcome = solver->solve(b, x, 1e-14);
    CAPTURE(outcome.residual, outcome.rounding, outcome.iterations);
    CHECK(outcome.converged);
    CHECK(outcome.residual > 1e-14);
    CHECK(outcome.residual <= outcome.rounding);
    CHECK(outcome.rounding < 1e-9);
  }
}
