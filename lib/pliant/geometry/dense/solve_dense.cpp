// lib/pliant/geometry/dense/solve_dense.cpp: small square systems, by Eigen's elimination with full pivoting.
#include "pliant/geometry/dense/solve_dense.h"

#include <Eigen/LU>
#include <array>
#include <utility>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr int most_known =
    8;  // the largest size that is known at compile time: flips up to degree 3 have no more than 5
constexpr int most_on_stack = 96;  // the largest that takes no memory of the heap; a flip at degree 10 has 82

/// The values are copied, column after column: Eigen then has them in its own alignment, whatever the caller's is.
template <int size, int most>
void eliminate(int n, const double* matrix, int columns, double* right) {
  using Square = Eigen::Matrix<double, size, size, Eigen::ColMajor, most, most>;
  using Column = Eigen::Matrix<double, size, 1, Eigen::ColMajor, most, 1>;
  // Rows read as columns: the transpose.
  const Eigen::FullPivLU<Square> factors(Eigen::Map<const Square>(matrix, n, n).transpose());
  for (int c = 0; c < columns; ++c) {
    Eigen::Map<Column, 0, Eigen::InnerStride<>> values(right + c, n, Eigen::InnerStride<>(columns));
    const Column known = values;
    values = factors.solve(known);
  }
}

using Elimination = void (*)(int n, const double* matrix, int columns, double* right);

template <int... less_by_one>
constexpr std::array<Elimination, sizeof...(less_by_one)> eliminations(std::integer_sequence<int, less_by_one...>) {
  return {eliminate<less_by_one + 1, less_by_one + 1>...};
}

}  // namespace

void solve_dense(int n, std::span<const double> matrix, int columns, std::span<double> right) {
  if (n == 0) return;
  static constexpr auto known = eliminations(std::make_integer_sequence<int, most_known>());
  if (n <= most_known)
    known[index(n - 1)](n, matrix.data(), columns, right.data());
  else if (n <= most_on_stack)
    eliminate<Eigen::Dynamic, most_on_stack>(n, matrix.data(), columns, right.data());
  else
    eliminate<Eigen::Dynamic, Eigen::Dynamic>(n, matrix.data(), columns, right.data());
}

}  // namespace pliant
