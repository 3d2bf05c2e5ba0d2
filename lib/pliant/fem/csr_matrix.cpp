// lib/pliant/fem/csr_matrix.cpp: products and sums in a fixed order.
#include "pliant/fem/csr_matrix.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pliant {

int CsrPattern::find(int row, int column) const {
  const auto first = columns.begin() + starts[static_cast<std::size_t>(row)];
  const auto last = columns.begin() + starts[static_cast<std::size_t>(row) + 1];
  const auto found = std::lower_bound(first, last, column);
  return found == last || *found != column ? -1 : static_cast<int>(found - columns.begin());
}

void multiply(const CsrMatrix& a, std::span<const double> x, std::span<double> y) {
  const CsrPattern& pattern = *a.pattern;
  assert(static_cast<int>(y.size()) == pattern.rows());
  const int* const columns = pattern.columns.data();
  const double* const values = a.values.data();
  for (std::size_t i = 0; i < y.size(); ++i) {
    double sum = 0;
    for (int k = pattern.starts[i]; k < pattern.starts[i + 1]; ++k)
      sum += values[k] * x[static_cast<std::size_t>(columns[k])];
    y[i] = sum;
  }
}

double dot(std::span<const double> a, std::span<const double> b) {
  assert(a.size() == b.size());
  // Four sums, so that one addition need not wait for the one before; which term goes where depends on its index alone.
  double sums[4] = {0, 0, 0, 0};
  const std::size_t n = a.size(), whole = n - n % 4;
  for (std::size_t i = 0; i < whole; i += 4)
    for (std::size_t k = 0; k < 4; ++k) sums[k] += a[i + k] * b[i + k];
  for (std::size_t i = whole; i < n; ++i) sums[0] += a[i] * b[i];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

double norm(std::span<const double> a) {
  const double squares = dot(a, a);
  if ((squares > 1e-280 && squares < 1e300) || std::isnan(squares)) return std::sqrt(squares);
  // Some squares may be out of range.
  double greatest = 0;
  for (const double x : a) greatest = std::max(greatest, std::abs(x));
  if (greatest == 0 || !std::isfinite(greatest)) return greatest;
  double sum = 0;
  for (const double x : a) sum += (x / greatest) * (x / greatest);
  return greatest * std::sqrt(sum);
}

}  // namespace pliant
