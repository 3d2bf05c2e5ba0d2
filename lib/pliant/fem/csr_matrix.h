// lib/pliant/fem/csr_matrix.h: sparse matrices by rows, with a pattern that several of them share.
#pragma once
#include <memory>
#include <span>
#include <vector>

namespace pliant {

/// Where a sparse matrix has entries: row i has those of `columns` from starts[i] to starts[i + 1], ascending.
struct CsrPattern {
  std::vector<int> starts{0};  ///< rows + 1
  std::vector<int> columns;

  int rows() const { return static_cast<int>(starts.size()) - 1; }
  /// The place of an entry among the values; none if the pattern does not have it.   Complexity  O(log row)
  int find(int row, int column) const;
};

/// A sparse matrix. Those of the finite elements have a symmetric pattern that holds the diagonal.
struct CsrMatrix {
  std::shared_ptr<const CsrPattern> pattern;
  std::vector<double> values;  ///< one for each of the pattern's columns

  int rows() const { return pattern->rows(); }
};

/// y = A x; each row is summed in the order of its columns.
void multiply(const CsrMatrix& a, std::span<const double> x, std::span<double> y);
/// Sums in a fixed order, so that they have the same bits everywhere.
double dot(std::span<const double> a, std::span<const double> b);
/// The Euclidean norm, also where squares are out of range.
double norm(std::span<const double> a);

}  // namespace pliant
