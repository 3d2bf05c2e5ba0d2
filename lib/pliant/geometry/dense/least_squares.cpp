// lib/pliant/geometry/dense/least_squares.cpp: Householder reflections, stored where they make zeros.
#include "pliant/geometry/dense/least_squares.h"

#include <algorithm>
#include <cmath>

namespace pliant {

std::span<double> LeastSquares::start(int rows, int columns) {
  rows_ = static_cast<std::size_t>(rows);
  columns_ = static_cast<std::size_t>(columns);
  matrix_.assign(rows_ * columns_, 0.0);
  diagonal_.assign(columns_, 0.0);
  return matrix_;
}

/// Applies the reflection of one column to `values`. From the diagonal down, a factored column holds the vector of its
/// reflection, of length sqrt(2); the diagonal itself is in diagonal_.
void LeastSquares::reflect(std::size_t column, double* values) const {
  const double* const v = matrix_.data() + column * rows_;
  double product = 0;
  for (std::size_t i = column; i < rows_; ++i) product += v[i] * values[i];
  for (std::size_t i = column; i < rows_; ++i) values[i] -= product * v[i];
}

bool LeastSquares::factor() {
  for (std::size_t j = 0; j < columns_; ++j) {
    double* const v = matrix_.data() + j * rows_;
    double whole = 0, rest = 0;
    for (std::size_t i = 0; i < rows_; ++i) (i < j ? whole : rest) += v[i] * v[i];
    whole += rest;
    if (!(rest > 1e-28 * whole)) return false;
    diagonal_[j] = v[j] > 0 ? -std::sqrt(rest) : std::sqrt(rest);
    v[j] -= diagonal_[j];
    const double scale = 1 / std::sqrt(-diagonal_[j] * v[j]);
    for (std::size_t i = j; i < rows_; ++i) v[i] *= scale;
    for (std::size_t k = j + 1; k < columns_; ++k) reflect(j, matrix_.data() + k * rows_);
  }
  return true;
}

void LeastSquares::solve(std::span<double> right) const {
  for (std::size_t j = 0; j < columns_; ++j) reflect(j, right.data());
  for (std::size_t j = columns_; j-- > 0;) {
    right[j] /= diagonal_[j];
    for (std::size_t i = 0; i < j; ++i) right[i] -= matrix_[j * rows_ + i] * right[j];
  }
}

}  // namespace pliant
