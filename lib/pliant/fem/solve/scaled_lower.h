// lib/pliant/fem/solve/scaled_lower.h: a symmetric matrix with a diagonal of ones, of which the lower triangle is
// stored.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "pliant/fem/csr_matrix.h"

namespace pliant {

/// D^-1/2 A D^-1/2 = L + I + L^T. L is stored by rows; half the matrix is half the memory to stream.
struct ScaledLower {
  std::vector<double> scaling;  ///< D^-1/2
  std::vector<int> starts;
  std::vector<int> columns;
  std::vector<double> values;  ///< of `factor` L

  /// Returns     an empty text, or why not: a diagonal entry that is not positive, numbers out of range
  std::string set(const CsrMatrix& a, double factor);

  /// y = (I + L)^-1 y, and y = (I + L)^-T y.
  void forward(std::span<double> y) const;
  void backward(std::span<double> y) const;
  /// y = L x, y = L^T x, and y = (L + I + L^T) x.
  void lower_product(std::span<const double> x, std::span<double> y) const;
  void upper_product(std::span<const double> x, std::span<double> y) const;
  void product(std::span<const double> x, std::span<double> y) const;
};

}  // namespace pliant
