// tests/fem/solve_matrices.h: systems for the solvers: of curved meshes, dense by rows, with known solutions.
#pragma once
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "pliant/fem/solve/coarse_space.h"
#include "pliant/fem/solve/linear_solver.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/improve/refine.h"
#include "support/bernstein_matrices.h"
#include "support/sample_boundaries.h"

namespace pliant::samples {

/// A round cell of radius 1 with curved elements of at most this area.
inline Mesh curved_cell(int degree, double area) {
  Mesh mesh;
  mesh_from_boundary(one_cell(degree), {degree}, mesh);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = area;
  refine(mesh, options);
  mesh.renumber();
  return mesh;
}

/// -div(grad u) with values given on the curve.
inline CsrMatrix poisson(const Mesh& mesh, const std::vector<double>& diffusivity = {}) {
  CsrMatrix a = mass_and_stiffness(mesh, diffusivity).stiffness;
  fix(a, on_curves(mesh));
  return a;
}

inline CsrMatrix heat(const Mesh& mesh, double dt) {
  const MassAndStiffness both = mass_and_stiffness(mesh);
  return sum(both.mass, dt, both.stiffness);
}

inline CoarseSpace hats(const Mesh& mesh) {
  std::vector<int> nets;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    nets.insert(nets.end(), mesh.net(t).begin(), mesh.net(t).end());
  return hat_functions(mesh.degree(), nets, mesh.point_slots());
}

/// A matrix from its rows; zeros are no entries, but those of the diagonal.
inline CsrMatrix from_rows(const std::vector<std::vector<double>>& rows) {
  const auto pattern = std::make_shared<CsrPattern>();
  CsrMatrix a;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows.size(); ++j)
      if (rows[i][j] != 0 || rows[j][i] != 0 || i == j) {
        pattern->columns.push_back(static_cast<int>(j));
        a.values.push_back(rows[i][j]);
      }
    pattern->starts.push_back(static_cast<int>(a.values.size()));
  }
  a.pattern = pattern;
  return a;
}

/// Row i of the result is row order[i] of the matrix, and so with columns.
inline CsrMatrix shuffled(const CsrMatrix& a, const std::vector<int>& order) {
  std::vector<int> places(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) places[index(order[k])] = static_cast<int>(k);
  const auto pattern = std::make_shared<CsrPattern>();
  CsrMatrix result;
  for (const int i : order) {
    std::vector<std::pair<int, double>> row;
    for (int k = a.pattern->starts[index(i)]; k < a.pattern->starts[index(i) + 1]; ++k)
      row.emplace_back(places[index(a.pattern->columns[index(k)])], a.values[index(k)]);
    std::ranges::sort(row);
    for (const auto& [column, value] : row) {
      pattern->columns.push_back(column);
      result.values.push_back(value);
    }
    pattern->starts.push_back(static_cast<int>(result.values.size()));
  }
  result.pattern = pattern;
  return result;
}

inline std::vector<int> random_order(int n, unsigned seed) {
  std::vector<int> order(index(n));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::shuffle(order, std::mt19937(seed));
  return order;
}

inline std::vector<double> random_values(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> values(index(n));
  for (double& x : values) x = static_cast<double>(random()) / 0x1p32 - 0.5;
  return values;
}

inline std::vector<double> product(const CsrMatrix& a, const std::vector<double>& x) {
  std::vector<double> y(x.size());
  multiply(a, x, y);
  return y;
}

/// |b - A x| / |b|, computed in long double.
inline double residual_of(const CsrMatrix& a, const std::vector<double>& b, const std::vector<double>& x) {
  long double left = 0, whole = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    long double sum = b[i];
    for (int k = a.pattern->starts[i]; k < a.pattern->starts[i + 1]; ++k)
      sum -= static_cast<long double>(a.values[index(k)]) * x[index(a.pattern->columns[index(k)])];
    left += sum * sum;
    whole += static_cast<long double>(b[i]) * b[i];
  }
  return static_cast<double>(std::sqrt(left / whole));
}

inline double greatest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double greatest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, std::abs(a[i] - b[i]));
  return greatest;
}

/// The solvers for symmetric positive definite matrices without a coarse space, and that for all.
inline std::vector<std::unique_ptr<LinearSolver>> all_solvers() {
  std::vector<std::unique_ptr<LinearSolver>> solvers;
  solvers.push_back(make_direct_symmetric());
  solvers.push_back(make_conjugate_gradients());
  solvers.push_back(make_direct_general());
  return solvers;
}
/// The same, and that of two levels with the hats of a mesh.
inline std::vector<std::unique_ptr<LinearSolver>> all_solvers(const Mesh& mesh) {
  std::vector<std::unique_ptr<LinearSolver>> solvers = all_solvers();
  solvers.push_back(make_two_level(hats(mesh)));
  return solvers;
}

}  // namespace pliant::samples
