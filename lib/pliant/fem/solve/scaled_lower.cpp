// lib/pliant/fem/solve/scaled_lower.cpp: products and triangular solutions, in a fixed order.
#include "pliant/fem/solve/scaled_lower.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "pliant/fem/solve/residual.h"
#include "pliant/geometry/describe.h"
#include "pliant/geometry/index.h"

namespace pliant {

std::string ScaledLower::set(const CsrMatrix& a, double factor) {
  if (std::string why = refuse_non_finite(a); !why.empty()) return why;
  const CsrPattern& pattern = *a.pattern;
  const std::size_t n = index(a.rows());
  scaling.assign(n, 0);
  starts.assign(1, 0);
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const int k = pattern.find(static_cast<int>(i), static_cast<int>(i));
    const double diagonal = k < 0 ? 0 : a.values[index(k)];
    if (!(diagonal > 0))
      return "the diagonal entry of row " + std::to_string(i) + " is " + describe_number(diagonal) +
             ": the matrix is not positive definite";
    scaling[i] = 1 / std::sqrt(diagonal);
    for (int e = pattern.starts[i]; e < pattern.starts[i + 1]; ++e)
      count += index(pattern.columns[index(e)]) < i && a.values[index(e)] != 0;
  }
  starts.reserve(n + 1);
  columns.clear();
  values.clear();
  columns.reserve(count);
  values.reserve(count);
  for (std::size_t i = 0; i < n; ++i) {
    for (int e = pattern.starts[i]; e < pattern.starts[i + 1]; ++e) {
      const std::size_t j = index(pattern.columns[index(e)]);
      if (j >= i || a.values[index(e)] == 0) continue;
      const double value = a.values[index(e)] * scaling[i] * scaling[j];
      // Rounding may put it a little above 1; in a positive definite matrix it is below.
      if (!(std::abs(value) < 1 + 1e-10))
        return "the entry of row " + std::to_string(i) + ", column " + std::to_string(j) +
               " is greater than the diagonal allows: the matrix is not positive definite";
      columns.push_back(static_cast<int>(j));
      values.push_back(factor * value);
    }
    starts.push_back(static_cast<int>(columns.size()));
  }
  return {};
}

void ScaledLower::forward(std::span<double> y) const {
  assert(y.size() + 1 == starts.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    double sum = y[i];
    for (int k = starts[i]; k < starts[i + 1]; ++k) sum -= values[index(k)] * y[index(columns[index(k)])];
    y[i] = sum;
  }
}

void ScaledLower::backward(std::span<double> y) const {
  for (std::size_t i = y.size(); i-- > 0;) {
    const double value = y[i];
    for (int k = starts[i]; k < starts[i + 1]; ++k) y[index(columns[index(k)])] -= values[index(k)] * value;
  }
}

void ScaledLower::lower_product(std::span<const double> x, std::span<double> y) const {
  for (std::size_t i = 0; i < y.size(); ++i) {
    double sum = 0;
    for (int k = starts[i]; k < starts[i + 1]; ++k) sum += values[index(k)] * x[index(columns[index(k)])];
    y[i] = sum;
  }
}

void ScaledLower::upper_product(std::span<const double> x, std::span<double> y) const {
  std::ranges::fill(y, 0);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double value = x[i];
    for (int k = starts[i]; k < starts[i + 1]; ++k) y[index(columns[index(k)])] += values[index(k)] * value;
  }
}

void ScaledLower::product(std::span<const double> x, std::span<double> y) const {
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double value = x[i];
    double sum = value;
    for (int k = starts[i]; k < starts[i + 1]; ++k) {
      const std::size_t j = index(columns[index(k)]);
      sum += values[index(k)] * x[j];
      y[j] += values[index(k)] * value;
    }
    y[i] = sum;
  }
}

}  // namespace pliant
