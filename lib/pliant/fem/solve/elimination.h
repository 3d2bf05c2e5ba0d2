// lib/pliant/fem/solve/elimination.h: in which order rows are eliminated, and what the factors' pattern then is.
#pragma once
#include <cstdint>
#include <vector>

#include "pliant/fem/csr_matrix.h"

namespace pliant {

/// An order of elimination for a symmetric pattern, the lower triangle of the matrix.
struct Elimination {
  std::vector<int> order;    ///< the k-th row that is eliminated
  std::vector<int> places;   ///< its inverse: when a row is eliminated
  std::vector<int> parents;  ///< of the k-th in the tree of elimination; -1 at roots
  std::vector<int> counts;   ///< entries below the diagonal in the k-th column of L

  std::int64_t fill() const;  ///< entries below the diagonal of L
};

/// The rows and columns in another order: row k has the entries of the lower triangle, by place; zeros are left out.
struct PermutedLower {
  std::vector<std::int64_t> starts;
  std::vector<int> columns;
  std::vector<double> values;  ///< scaled: s_i a_ij s_j
  std::vector<double> diagonal;
};

/// By approximate minimum degree, in postorder of the tree of elimination.
/// Throws      std::length_error where the pattern is too large for its numbers
Elimination order_by_minimum_degree(const CsrMatrix& a);
PermutedLower permute(const CsrMatrix& a, const std::vector<double>& scaling, const std::vector<int>& places);

}  // namespace pliant
