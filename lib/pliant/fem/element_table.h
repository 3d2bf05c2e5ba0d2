// lib/pliant/fem/element_table.h: the basis of an element at the points of a quadrature rule, and products of it.
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// What the matrices of all elements of one degree share, for one rule. Derivatives are with respect to xi2 and xi3.
struct ElementTable {
  int degree = 0;
  int size = 0;    ///< basis functions n
  int points = 0;  ///< of the rule, m
  std::vector<Barycentric> xi;
  std::vector<double> weights;  ///< they sum to 1/2

  // m x n, point after point
  std::vector<double> values, along_2, along_3;
  /// Pairs of basis functions: the lower triangle row after row, n (n + 1) / 2 of them.
  int pairs = 0;
  /// m x pairs: weight * B_i B_j.
  std::vector<double> masses;
  /// m x 3 x pairs: weight times D2_i D2_j, D2_i D3_j + D3_i D2_j, and D3_i D3_j.
  std::vector<double> gradients;

  std::span<const double> values_at(int q) const { return row(values, q); }
  std::span<const double> along_2_at(int q) const { return row(along_2, q); }
  std::span<const double> along_3_at(int q) const { return row(along_3, q); }

 private:
  std::span<const double> row(const std::vector<double>& table, int q) const {
    return std::span(table).subspan(static_cast<std::size_t>(q) * static_cast<std::size_t>(size),
                                    static_cast<std::size_t>(size));
  }
};

/// The most exact rule that there is a table for.
inline constexpr int greatest_exact_degree = 40;

/// The table for elements of a degree and a rule of an exactness (symmetric_rule), built once; thread-safe.
const ElementTable& element_table(int degree, int exact_degree);

}  // namespace pliant
