// lib/pliant/fem/solve/sparse_ldlt.h: L D L^T of a sparse symmetric matrix, without pivoting, by supernodes.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "pliant/fem/solve/elimination.h"
#include "pliant/fem/solve/supernodes.h"

namespace pliant {

/// Factors S A S = P^T L D L^T P.
class SparseLdlt {
 public:
  /// Where elimination cannot go on, or finds the matrix singular up to rounding.
  struct Fault {
    int row;
    double pivot;  ///< of the scaled matrix
    bool is_singular;
  };

  /// `signs` are what the pivots must have, 1 or -1, row by row (all 1 where it is empty); `shift` is added to the
  /// scaled diagonal (nothing where it is empty).
  std::optional<Fault> factor(const CsrMatrix& a, std::vector<double> scaling, std::span<const signed char> signs = {},
                              std::span<const double> shift = {});
  /// Overwrites b with the solution of A x = b.
  void solve(std::span<double> b) const;
  /// Entries of L that are stored.
  std::int64_t stored() const { return supernodes_.value_starts.back(); }

 private:
  void assemble(const PermutedLower& lower);
  void eliminate(int s, int descendant, int from, int to, std::vector<double>& product, std::vector<double>& weighted,
                 const std::vector<int>& places);
  std::optional<Fault> factor_panel(int s, std::span<const signed char> signs, std::vector<double>& weighted);
  std::optional<Fault> find_singular(const PermutedLower& lower) const;
  void backward(std::span<double> x) const;
  const int* rows(int s) const { return supernodes_.rows.data() + supernodes_.row_starts[static_cast<std::size_t>(s)]; }
  int height(int s) const {
    const auto i = static_cast<std::size_t>(s);
    return static_cast<int>(supernodes_.row_starts[i + 1] - supernodes_.row_starts[i]);
  }
  int width(int s) const {
    const auto i = static_cast<std::size_t>(s);
    return supernodes_.firsts[i + 1] - supernodes_.firsts[i];
  }
  double* panel(int s) { return values_.data() + supernodes_.value_starts[static_cast<std::size_t>(s)]; }
  const double* panel(int s) const { return values_.data() + supernodes_.value_starts[static_cast<std::size_t>(s)]; }

  std::vector<double> scaling_;
  std::vector<int> order_;
  Supernodes supernodes_;
  std::vector<double> values_;  ///< L by panels, with D on the diagonal
};

}  // namespace pliant
