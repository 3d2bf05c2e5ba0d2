// lib/pliant/geometry/dense/solve_dense.cpp: small square systems, solved without allocation in the long run.
#include "pliant/geometry/dense/solve_dense.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pliant {

void solve_dense(int n, std::span<double> matrix, int columns, std::span<double> right) {
  const auto size = static_cast<std::size_t>(n), width = static_cast<std::size_t>(columns);
  thread_local std::vector<std::size_t> order;  // of the unknowns
  thread_local std::vector<double> found;
  order.resize(size);
  for (std::size_t k = 0; k < size; ++k) order[k] = k;
  double* const a = matrix.data();
  double* const b = right.data();
  std::size_t rank = 0;
  for (double largest = 0; rank < size; ++rank) {
    std::size_t row = rank, column = rank;
    double pivot = 0;
    for (std::size_t i = rank; i < size; ++i)
      for (std::size_t j = rank; j < size; ++j)
        if (std::abs(a[i * size + j]) > pivot) pivot = std::abs(a[i * size + j]), row = i, column = j;
    largest = std::max(largest, pivot);
    if (!(pivot > n * std::numeric_limits<double>::epsilon() * largest)) break;
    if (row != rank) {
      std::swap_ranges(a + row * size, a + (row + 1) * size, a + rank * size);
      std::swap_ranges(b + row * width, b + (row + 1) * width, b + rank * width);
    }
    if (column != rank) {
      for (std::size_t i = 0; i < size; ++i) std::swap(a[i * size + column], a[i * size + rank]);
      std::swap(order[column], order[rank]);
    }
    for (std::size_t i = rank + 1; i < size; ++i) {
      const double factor = a[i * size + rank] / a[rank * size + rank];
      for (std::size_t j = rank + 1; j < size; ++j) a[i * size + j] -= factor * a[rank * size + j];
      for (std::size_t c = 0; c < width; ++c) b[i * width + c] -= factor * b[rank * width + c];
    }
  }
  found.assign(size * width, 0.0);
  for (std::size_t i = rank; i-- > 0;)
    for (std::size_t c = 0; c < width; ++c) {
      double value = b[i * width + c];
      for (std::size_t j = i + 1; j < rank; ++j) value -= a[i * size + j] * found[order[j] * width + c];
      found[order[i] * width + c] = value / a[i * size + i];
    }
  std::copy(found.begin(), found.end(), b);
}

}  // namespace pliant
