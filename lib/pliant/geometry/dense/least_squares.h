// lib/pliant/geometry/dense/least_squares.h: more equations than unknowns, solved without allocation in the long run.
#pragma once
#include <span>
#include <vector>

namespace pliant {

/// Householder's factors of a matrix with linearly independent columns; memory is reused from one to the next.
class LeastSquares {
 public:
  /// The matrix to be filled, column after column: entry (i, j) at j * rows + i. Zero at first.
  std::span<double> start(int rows, int columns);
  /// False if the columns depend on one another, to rounding.   Complexity O(rows * columns^2)
  bool factor();
  /// Replaces `right` (rows values) by the solution, in its first places.   Complexity O(rows * columns)
  void solve(std::span<double> right) const;

 private:
  void reflect(std::size_t column, double* values) const;
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<double> matrix_, diagonal_;
};

}  // namespace pliant
