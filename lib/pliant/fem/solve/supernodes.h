// lib/pliant/fem/solve/supernodes.h: columns of L that have their rows in common, for dense arithmetic.
#pragma once
#include <cstdint>
#include <vector>

#include "pliant/fem/solve/elimination.h"

namespace pliant {

/// Columns from firsts[s] to firsts[s + 1] have the same rows: rows[row_starts[s]] to rows[row_starts[s + 1]],
/// ascending, of which the first are those columns. Some entries are zeros, where columns were joined that differ a
/// little.
struct Supernodes {
  std::vector<int> firsts{0};
  std::vector<int> of_column;
  std::vector<std::int64_t> row_starts{0};
  std::vector<int> rows;
  std::vector<std::int64_t> value_starts{0};  ///< of the panels, each rows x columns

  int size() const { return static_cast<int>(firsts.size()) - 1; }
};

/// `lower` has the pattern of the matrix in the order of elimination.
Supernodes find_supernodes(const Elimination& elimination, const PermutedLower& lower);

}  // namespace pliant
