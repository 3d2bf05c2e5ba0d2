// lib/pliant/geometry/dense/least_squares.h: systems with more equations than unknowns, in memory that is reused.
#pragma once
#include <span>
#include <vector>

namespace pliant {

/// The QR factors, by Householder reflections, of a matrix with linearly independent columns. The memory is reused from
/// one matrix to the next.
class LeastSquares {
 public:
  /// The entries of a new matrix, all 0, for the caller to fill column after column: entry (i, j) at j * rows + i.
  std::span<double> start(int rows, int columns);
  /// Factors the matrix; false if its columns are linearly dependent, to rounding.   Complexity O(rows * columns^2)
  bool factor();
  /// Replaces the first `columns` values of `right`, which has `rows`, by the solution.   Complexity O(rows * columns)
  void solve(std::span<double> right) const;

 private:
  void reflect(std::size_t column, double* values) const;
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<double> matrix_, diagonal_;
};

}  // namespace pliant
