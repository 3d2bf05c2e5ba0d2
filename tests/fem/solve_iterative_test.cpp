// tests/fem/solve_iterative_test.cpp: iterations, guesses, coarse spaces, and which solver is chosen.
#include <catch2/catch.hpp>

#include "solve_matrices.h"

using namespace pliant;
using namespace pliant::samples;

TEST_CASE("hat functions sum to one and reproduce the vertices' linear functions, at any degree", "[fem]") {
  const int degree = GENERATE(range(1, 6));
  const Mesh mesh = curved_cell(degree, 0.2);
  const CoarseSpace space = hats(mesh);
  int vertices = 0;
  for (PointId p = 0; p < mesh.point_slots(); ++p) vertices += mesh.is_vertex(p);
  CHECK(space.size == vertices);
  // The coefficients of a hat along an edge fall from 1 to 0 in steps of 1/p; a vertex has its own hat alone.
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    double total = 0;
    for (int k = space.starts[index(p)]; k < space.starts[index(p) + 1]; ++k) total += space.weights[index(k)];
    CHECK(total == Approx(1).epsilon(1e-15));
    if (mesh.is_vertex(p)) CHECK(space.starts[index(p) + 1] - space.starts[index(p)] == 1);
  }
  for (const HalfEdgeId h : mesh.half_edges())
    for (int j = 1; j < degree; ++j) {
      const std::size_t p = index(mesh.edge_point(h, j)), start = index(mesh.origin(h));
      const int hat = space.columns[index(space.starts[start])];
      double weight = 0;
      for (int k = space.starts[p]; k < space.starts[p + 1]; ++k)
        if (space.columns[index(k)] == hat) weight += space.weights[index(k)];
      CHECK(weight == Approx(1 - double(j) / degree).epsilon(1e-15));
    }
}

TEST_CASE("the iterations of two levels do not grow with the mesh", "[fem]") {
  const int degree = GENERATE(2, 3, 4);
  std::vector<int> iterations;
  for (const double area : {0.04, 0.01, 0.0025}) {
    const Mesh mesh = curved_cell(degree, area);
    const CsrMatrix a = poisson(mesh);
    const auto solver = make_two_level(hats(mesh));
    REQUIRE(solver->factor(a).empty());
    const std::vector<double> b = random_values(a.rows(), 3);
    std::vector<double> x(b.size(), 0);
    const SolveOutcome outcome = solver->solve(b, x, solver_tolerance);
    CHECK(outcome.converged);
    iterations.push_back(outcome.iterations);
  }
  CAPTURE(degree, iterations);
  CHECK(iterations.back() <= iterations.front() + 4);
  CHECK(iterations.back() <= (degree == 2 ? 20 : degree == 3 ? 35 : 60));
}

TEST_CASE("unknowns may be left out, and their vertices have no hat", "[fem]") {
  const Mesh mesh = curved_cell(3, 0.02);
  const std::vector<bool> fixed = on_curves(mesh);
  std::vector<int> numbers(fixed.size(), -1), kept, nets;
  for (std::size_t i = 0; i < fixed.size(); ++i)
    if (!fixed[i]) {
      numbers[i] = static_cast<int>(kept.size());
      kept.push_back(static_cast<int>(i));
    }
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (const PointId p : mesh.net(t)) nets.push_back(numbers[index(p)]);
  const CsrMatrix whole = poisson(mesh);
  const auto pattern = std::make_shared<CsrPattern>();
  CsrMatrix a;
  for (const int i : kept) {
    for (int k = whole.pattern->starts[index(i)]; k < whole.pattern->starts[index(i) + 1]; ++k)
      if (const int j = numbers[index(whole.pattern->columns[index(k)])]; j >= 0) {
        pattern->columns.push_back(j);
        a.values.push_back(whole.values[index(k)]);
      }
    pattern->starts.push_back(static_cast<int>(a.values.size()));
  }
  a.pattern = pattern;
  const auto solver = make_two_level(hat_functions(3, nets, a.rows()));
  REQUIRE(solver->factor(a).empty());
  const std::vector<double> expected = random_values(a.rows(), 41), b = product(a, expected);
  std::vector<double> x(b.size(), 0);
  const SolveOutcome outcome = solver->solve(b, x, solver_tolerance);
  CHECK(outcome.converged);
  CHECK(outcome.iterations <= 35);
  CHECK(greatest_difference(x, expected) < 1e-9);
}

TEST_CASE("a good guess saves iterations, the solution itself needs none, a bad one does no harm", "[fem]") {
  const Mesh mesh = curved_cell(2, 0.005);
  const CsrMatrix a = heat(mesh, 1e-3);
  std::vector<std::unique_ptr<LinearSolver>> solvers;
  solvers.push_back(make_conjugate_gradients());
  solvers.push_back(make_two_level(hats(mesh)));
  const std::vector<double> expected = random_values(a.rows(), 43), b = product(a, expected),
                            noise = random_values(a.rows(), 47);
  for (const auto& solver : solvers) {
    CAPTURE(solver->name());
    REQUIRE(solver->factor(a).empty());
    const auto iterations_from = [&](std::vector<double> x) {
      const SolveOutcome outcome = solver->solve(b, x, solver_tolerance);
      CHECK(outcome.converged);
      CHECK(greatest_difference(x, expected) < 1e-9);
      return outcome.iterations;
    };
    std::vector<double> near = expected, far = noise;
    for (std::size_t i = 0; i < near.size(); ++i) near[i] += 1e-7 * noise[i], far[i] *= 1e200;
    const int from_zero = iterations_from(std::vector<double>(b.size(), 0));
    CHECK(iterations_from(near) < 3 * from_zero / 4);
    CHECK(iterations_from(expected) == 0);
    CHECK(iterations_from(far) == from_zero);
  }
}

TEST_CASE("a coarse space that is no subspace of use only costs iterations", "[fem]") {
  const CsrMatrix a = from_rows({{4, 1, 0}, {1, 3, 1}, {0, 1, 5}});
  CoarseSpace all;  // one function: the constant
  all.size = 1;
  all.starts = {0, 1, 2, 3};
  all.columns = {0, 0, 0};
  all.weights = {1, 1, 1};
  CoarseSpace nothing;
  nothing.starts = {0, 0, 0, 0};
  for (const CoarseSpace& space : {all, nothing}) {
    const auto solver = make_two_level(space);
    REQUIRE(solver->factor(a).empty());
    const std::vector<double> b = product(a, {1, -2, 3});
    std::vector<double> x(3, 0);
    CHECK(solver->solve(b, x, solver_tolerance).converged);
    CHECK(greatest_difference(x, {1, -2, 3}) < 1e-11);
  }
}

TEST_CASE("the solver is chosen by the size of the system and by what is known of it", "[fem]") {
  const auto chosen = [](const CsrMatrix& a, bool mass, const CoarseSpace* coarse) {
    const auto solver = make_symmetric_solver(a.rows(), mass, coarse);
    CHECK(solver->factor(a).empty());
    return std::string(solver->name());
  };
  const Mesh few = curved_cell(2, 0.01), many = curved_cell(2, 0.001);
  const CoarseSpace few_hats = hats(few), many_hats = hats(many);
  CHECK(chosen(poisson(few), false, nullptr) == "LDL^T");
  CHECK(chosen(heat(few, 1e-6), true, &few_hats) == "LDL^T");
  CHECK(chosen(poisson(many), false, nullptr) == "LDL^T");
  CHECK(chosen(poisson(many), false, &many_hats) == "two-level conjugate gradients");
  for (const CoarseSpace* coarse : {static_cast<const CoarseSpace*>(nullptr), &many_hats})
    CHECK(chosen(heat(many, 1e-4), true, coarse) == "conjugate gradients");
  // A step so long that hardly any mass is left.
  CHECK(chosen(heat(many, 10), true, nullptr) == "LDL^T");
  CHECK(chosen(heat(many, 10), true, &many_hats) == "two-level conjugate gradients");
  // At degree 1 the hats are all there is.
  const Mesh straight = curved_cell(1, 0.0005);
  const CoarseSpace all = hats(straight);
  CHECK(chosen(poisson(straight), false, &all) == "LDL^T");
  // Values that are given do not hide how little mass there is.
  CsrMatrix held = heat(many, 10);
  fix(held, on_curves(many));
  CHECK(chosen(held, true, &many_hats) == "two-level conjugate gradients");
}
