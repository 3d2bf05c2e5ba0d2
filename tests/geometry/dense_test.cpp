// tests/geometry/dense_test.cpp: laws of small square systems and least squares.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "pliant/geometry/dense/least_squares.h"
#include "pliant/geometry/dense/solve_dense.h"
#include "pliant/geometry/index.h"

using namespace pliant;

namespace {

struct System {
  int n, columns;
  std::vector<double> matrix, right;  // row after row

  /// The largest |matrix * x - right|.
  double residual(const std::vector<double>& x) const {
    double largest = 0;
    for (int i = 0; i < n; ++i)
      for (int c = 0; c < columns; ++c) {
        double rest = -right[index(i * columns + c)];
        for (int j = 0; j < n; ++j) rest += matrix[index(i * n + j)] * x[index(j * columns + c)];
        largest = std::fmax(largest, std::abs(rest));
      }
    return largest;
  }
};

System random_system(int n, int columns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> entry(-1, 1);
  System system{n, columns, std::vector<double>(index(n * n)), std::vector<double>(index(n * columns))};
  for (double& value : system.matrix) value = entry(random);
  for (double& value : system.right) value = entry(random);
  return system;
}

double greatest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::fmax(most, std::abs(value));
  return most;
}

}  // namespace

TEST_CASE("a dense system is solved to rounding, of every size and for any number of right sides", "[geometry]") {
  const int n = GENERATE(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 17, 40, 96, 97, 130), columns = GENERATE(1, 2, 3);
  CAPTURE(n, columns);
  const System system = random_system(n, columns, 7);
  std::vector<double> x = system.right;
  solve_dense(n, system.matrix, columns, x);
  CHECK(system.residual(x) <= 1e-14 * n * greatest(x));
}

TEST_CASE("what a dense system does not determine is 0, and the rest is solved", "[geometry]") {
  const int n = GENERATE(2, 3, 5, 8, 12, 40, 110), missing = GENERATE(1, 2);
  CAPTURE(n, missing);
  if (missing == n) return;
  // The last rows are sums of others, on the right side too.
  System system = random_system(n, 1, 11);
  for (int row = n - missing; row < n; ++row) {
    const int other = row - (n - missing);
    for (int j = 0; j < n; ++j)
      system.matrix[index(row * n + j)] = 2 * system.matrix[index(other % (n - missing) * n + j)];
    system.right[index(row)] = 2 * system.right[index(other % (n - missing))];
  }
  std::vector<double> x = system.right;
  solve_dense(n, system.matrix, 1, x);
  CHECK(system.residual(x) <= 1e-13 * n * std::fmax(1, greatest(x)));
  CHECK(std::count(x.begin(), x.end(), 0.0) == missing);
}

TEST_CASE("an equation of nothing leaves nothing", "[geometry]") {
  const int n = GENERATE(1, 4, 20);
  const std::vector<double> matrix(index(n * n), 0.0);
  std::vector<double> x(index(n), 1.0);
  solve_dense(n, matrix, 1, x);
  CHECK(greatest(x) == 0);
  solve_dense(0, {}, 1, {});
}

TEST_CASE("where a system lies in memory does not change its solution's bits", "[geometry]") {
  const int n = GENERATE(1, 3, 5, 8, 9, 16, 17, 50, 101);
  CAPTURE(n);
  const System system = random_system(n, 2, 3);
  std::vector<double> first;
  for (std::size_t shift = 0; shift < 8; ++shift) {
    std::vector<double> matrix(system.matrix.size() + shift), right(system.right.size() + shift);
    std::copy(system.matrix.begin(), system.matrix.end(), matrix.begin() + static_cast<std::ptrdiff_t>(shift));
    std::copy(system.right.begin(), system.right.end(), right.begin() + static_cast<std::ptrdiff_t>(shift));
    solve_dense(n, std::span<const double>(matrix).subspan(shift), 2, std::span<double>(right).subspan(shift));
    const std::vector<double> x(right.begin() + static_cast<std::ptrdiff_t>(shift), right.end());
    if (shift == 0) first = x;
    CHECK(x == first);
  }
}

TEST_CASE("columns of very different scales are solved each in its own", "[geometry]") {
  const int n = 6;
  System system = random_system(n, 1, 5);
  std::vector<double> x = system.right;
  solve_dense(n, system.matrix, 1, x);
  System scaled = system;  // by powers of two: exact
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) scaled.matrix[index(i * n + j)] = std::ldexp(system.matrix[index(i * n + j)], 4 * j);
  std::vector<double> y = scaled.right;
  solve_dense(n, scaled.matrix, 1, y);
  for (int j = 0; j < n; ++j) CHECK(std::ldexp(y[index(j)], 4 * j) == Approx(x[index(j)]).epsilon(1e-10));
}

TEST_CASE("what least squares leave is orthogonal to the columns", "[geometry]") {
  const auto [rows, columns] =
      GENERATE(std::pair{6, 1}, std::pair{8, 2}, std::pair{12, 4}, std::pair{63, 6}, std::pair{198, 36});
  CAPTURE(rows, columns);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> entry(-1, 1);
  std::vector<double> matrix(index(rows * columns)), right(index(rows));
  for (double& value : matrix) value = entry(random);
  for (double& value : right) value = entry(random);
  LeastSquares squares;
  std::ranges::copy(matrix, squares.start(rows, columns).begin());
  REQUIRE(squares.factor());
  std::vector<double> x = right;
  squares.solve(x);
  std::vector<double> rest = right;
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) rest[index(i)] -= matrix[index(j * rows + i)] * x[index(j)];
  for (int j = 0; j < columns; ++j) {
    double product = 0;
    for (int i = 0; i < rows; ++i) product += matrix[index(j * rows + i)] * rest[index(i)];
    CHECK(std::abs(product) <= 1e-13 * rows);
  }
}

TEST_CASE("columns that depend on one another are refused by least squares, at any scale", "[geometry]") {
  const int scale = GENERATE(-300, 0, 300);
  CAPTURE(scale);
  LeastSquares squares;
  const std::span<double> matrix = squares.start(4, 2);
  for (std::size_t i = 0; i < 4; ++i) {
    matrix[i] = static_cast<double>(i) + 1;
    matrix[4 + i] = std::ldexp(3 * matrix[i], scale);
  }
  CHECK_FALSE(squares.factor());
}
