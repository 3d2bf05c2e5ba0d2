// tests/fem/solve_saddle_test.cpp: saddle point systems, as those of Stokes.
#include <catch2/catch.hpp>

#include "pliant/fem/solve/gmres.h"
#include "solve_matrices.h"

using namespace pliant;
using namespace pliant::samples;
using Catch::Matchers::Contains;

namespace {

struct Saddle {
  CsrMatrix a;
  std::vector<bool> multipliers;
};

/// Stokes with velocities of degree 2 and pressures of degree 1 on a curved mesh. Velocities are 0 on the curve, so
/// that pressures are known up to a constant; where it is not enclosed, half of the curve lets the fluid pass, which
/// fixes it. In half of the triangles the viscosity is `jump` times as great.
Saddle stokes(double area, double viscosity, bool is_enclosed, double jump = 1) {
  const Mesh mesh = curved_cell(2, area);
  const std::size_t n = index(mesh.point_slots());
  std::vector<double> shares;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    shares.push_back(mesh.point(mesh.corner(t, 0)).y < 0 ? jump : 1);
  const CsrMatrix stiffness = mass_and_stiffness(mesh, shares).stiffness;
  const std::vector<bool> fixed = on_curves(mesh);
  std::vector<int> pressures(n, -1);
  int count = 0;
  for (PointId p = 0; p < mesh.point_slots(); ++p)
    if (mesh.is_vertex(p)) pressures[index(p)] = count++;
  const std::size_t size = 2 * n + index(count);
  std::vector<std::vector<std::pair<int, double>>> rows(size);
  const auto is_fixed = [&](std::size_t p) {
    return fixed[p] && (is_enclosed || mesh.point(static_cast<PointId>(p)).x < 0.5);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (int k = stiffness.pattern->starts[i]; k < stiffness.pattern->starts[i + 1]; ++k) {
      const std::size_t j = index(stiffness.pattern->columns[index(k)]);
      const double value = is_fixed(i) || is_fixed(j) ? (i == j ? 1 : 0) : viscosity * stiffness.values[index(k)];
      for (std::size_t c = 0; c < 2; ++c) rows[c * n + i].emplace_back(static_cast<int>(c * n + j), value);
    }
  for (std::size_t p = 2 * n; p < size; ++p) rows[p].emplace_back(static_cast<int>(p), 0);
  // -∫ q div v, entry by entry; those of one pair come from up to two triangles.
  const auto rule = triangle_rule(6);
  std::vector<Point> net(6);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    mesh.gather_points(t, net);
    double block[3][12] = {};
    for (const TriangleNode& node : rule) {
      const BasisAt basis(2, node.xi);
      Vector along_2, along_3;
      for (std::size_t m = 0; m < 6; ++m) along_2 += basis.along_2[m] * net[m], along_3 += basis.along_3[m] * net[m];
      for (std::size_t q = 0; q < 3; ++q)
        for (std::size_t m = 0; m < 6; ++m) {
          const double w = -node.weight * node.xi[q];
          block[q][m] += w * (along_3.y * basis.along_2[m] - along_2.y * basis.along_3[m]);
          block[q][6 + m] += w * (along_2.x * basis.along_3[m] - along_3.x * basis.along_2[m]);
        }
    }
    for (std::size_t q = 0; q < 3; ++q)
      for (std::size_t m = 0; m < 12; ++m) {
        const std::size_t point = index(mesh.net(t)[m % 6]), velocity = m / 6 * n + point;
        const std::size_t pressure = 2 * n + index(pressures[index(mesh.corner(t, static_cast<int>(q)))]);
        if (is_fixed(point)) continue;
        rows[velocity].emplace_back(static_cast<int>(pressure), block[q][m]);
        rows[pressure].emplace_back(static_cast<int>(velocity), block[q][m]);
      }
  }
  const auto pattern = std::make_shared<CsrPattern>();
  Saddle result;
  for (auto& row : rows) {
    std::stable_sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k > 0 && row[k].first == row[k - 1].first) {
        result.a.values.back() += row[k].second;
        continue;
      }
      pattern->columns.push_back(row[k].first);
      result.a.values.push_back(row[k].second);
    }
    pattern->starts.push_back(static_cast<int>(pattern->columns.size()));
  }
  result.a.pattern = pattern;
  result.multipliers.assign(size, false);
  std::fill(result.multipliers.begin() + static_cast<std::ptrdiff_t>(2 * n), result.multipliers.end(), true);
  return result;
}

}  // namespace

TEST_CASE("Stokes systems are solved by LDL^T and by LU alike, whatever the viscosity", "[fem]") {
  for (const double viscosity : {1.0, 1e-3, 1e6}) {
    CAPTURE(viscosity);
    const Saddle stokes_system = stokes(0.02, viscosity, false);
    const CsrMatrix& a = stokes_system.a;
    const std::vector<double> expected = random_values(a.rows(), 13), b = product(a, expected);
    const auto symmetric = make_quasi_definite(stokes_system.multipliers), general = make_direct_general();
    for (LinearSolver* solver : {symmetric.get(), general.get()}) {
      CAPTURE(solver->name());
      REQUIRE(solver->factor(a).empty());
      std::vector<double> x(b.size(), 0);
      const SolveOutcome outcome = solver->solve(b, x, solver_tolerance);
      CAPTURE(outcome.residual, outcome.refinements, outcome.why);
      CHECK(outcome.converged);
      CHECK(outcome.residual <= solver_tolerance);
      CHECK(outcome.refinements <= 4);
      double greatest = 0;  // of velocities; pressures are of the size of the viscosity
      for (std::size_t i = 0; i < x.size(); ++i)
        if (!stokes_system.multipliers[i]) greatest = std::max(greatest, std::abs(x[i] - expected[i]));
      CHECK(greatest < 1e-7);
    }
  }
}

TEST_CASE("a regularisation only costs refinements: the solution does not have it", "[fem]") {
  const Saddle system = stokes(0.02, 1, false);
  const std::vector<double> b = product(system.a, random_values(system.a.rows(), 17));
  for (const double regularisation : {1e-10, 1e-8, 1e-6}) {
    CAPTURE(regularisation);
    const auto solver = make_quasi_definite(system.multipliers, regularisation);
    REQUIRE(solver->factor(system.a).empty());
    std::vector<double> x(b.size(), 0);
    const SolveOutcome outcome = solver->solve(b, x, solver_tolerance);
    CHECK(outcome.converged);
    CHECK(residual_of(system.a, b, x) <= 1.1 * solver_tolerance);
  }
}

TEST_CASE("where the viscosity is great, or jumps, the regularisation is no part of the solution either", "[fem]") {
  // The norm of the residual is that of rows with the viscosity: 1e-12 of it says little of the others.
  for (const auto& [viscosity, jump] : {std::pair(1e3, 1.0), std::pair(1.0, 1e3)}) {
    CAPTURE(viscosity, jump);
    const Saddle system = stokes(0.02, viscosity, false, jump);
    const std::vector<double> expected = random_values(system.a.rows(), 23), b = product(system.a, expected);
    const auto solver = make_quasi_definite(system.multipliers);
    REQUIRE(solver->factor(system.a).empty());
    std::vector<double> x(b.size(), 0);
    REQUIRE(solver->solve(b, x, solver_tolerance).converged);
    double velocity = 0, pressure = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      double& greatest = system.multipliers[i] ? pressure : velocity;
      greatest = std::max(greatest, std::abs(x[i] - expected[i]));
    }
    CHECK(velocity < 1e-12);
    CHECK(pressure < 1e-12 * viscosity * jump);
  }
}

TEST_CASE("GMRES with a factor of Stokes finds velocities also where the viscosity is great, or jumps", "[fem]") {
  for (const auto& [viscosity, jump] : {std::pair(1.0, 1e3), std::pair(1e3, 1.0), std::pair(1e3, 1e3)}) {
    CAPTURE(viscosity, jump);
    const Saddle system = stokes(0.02, viscosity, false, jump);
    const auto factors = make_quasi_definite(system.multipliers);
    REQUIRE(factors->factor(system.a).empty());
    CsrMatrix a = system.a;
    const CsrPattern& pattern = *a.pattern;
    for (int i = 0; i < a.rows(); ++i)  // a skew part, as convection has
      for (int k = pattern.starts[index(i)]; k < pattern.starts[index(i) + 1]; ++k)
        if (const int j = pattern.columns[index(k)]; !system.multipliers[index(i)] && !system.multipliers[index(j)])
          if (a.values[index(k)] != 0 && i != j) a.values[index(k)] += i < j ? 0.1 : -0.1;
    const std::vector<double> expected = random_values(a.rows(), 29), b = product(a, expected);
    std::vector<double> x(b.size(), 0);
    const SolveOutcome outcome = solve_by_gmres(a, *factors, b, x);
    CAPTURE(outcome.residual, outcome.iterations, outcome.why);
    CHECK(outcome.converged);
    double velocity = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!system.multipliers[i]) velocity = std::max(velocity, std::abs(x[i] - expected[i]));
    CAPTURE(std::log10(velocity));
    CHECK(velocity < 1e-10);
  }
}

TEST_CASE("an enclosed flow is solved, whose pressure is known up to a constant", "[fem]") {
  const Saddle system = stokes(0.02, 1, true);
  // Consistent: it is an image of the matrix.
  const std::vector<double> expected = random_values(system.a.rows(), 19), b = product(system.a, expected);
  const auto solver = make_quasi_definite(system.multipliers);
  REQUIRE(solver->factor(system.a).empty());
  std::vector<double> x(b.size(), 0);
  const SolveOutcome outcome = solver->solve(b, x, solver_tolerance);
  CAPTURE(outcome.residual, outcome.refinements, outcome.why);
  CHECK(outcome.converged);
  double greatest = 0, shift = 0;
  bool has_shift = false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!system.multipliers[i]) greatest = std::max(greatest, std::abs(x[i] - expected[i]));
    if (system.multipliers[i] && !has_shift) shift = x[i] - expected[i], has_shift = true;
    if (system.multipliers[i]) greatest = std::max(greatest, std::abs(x[i] - expected[i] - shift));
  }
  CHECK(greatest < 1e-6);
}

TEST_CASE("multipliers that are none, and unknowns that are multipliers, are refused with the row", "[fem]") {
  const Saddle system = stokes(0.1, 1, false);
  std::vector<bool> none(system.multipliers.size(), false), wrong = system.multipliers;
  CHECK_THAT(make_quasi_definite(none)->factor(system.a),
             Contains("pivot of row") && Contains("no saddle point matrix"));
  wrong[0] = true;
  CHECK_THAT(make_quasi_definite(wrong)->factor(system.a), Contains("pivot of row"));
  CHECK_THAT(make_direct_symmetric()->factor(system.a), Contains("not positive definite"));
}
