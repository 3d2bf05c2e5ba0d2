// lib/pliant/fem/sparsity.h: the pattern of a matrix, and where the entries of element matrices go.
#pragma once
#include <span>
#include <vector>

#include "pliant/fem/csr_matrix.h"

namespace pliant {

/// Groups of unknowns that meet in one small matrix each: the unknowns of elements, or those on both sides of edges.
struct Groups {
  int size = 0;                  ///< unknowns in each group
  std::span<const int> members;  ///< of group after group

  int count() const { return size == 0 ? 0 : static_cast<int>(members.size()) / size; }
};

/// The pattern in which all unknowns of a group meet, and for each group, row by row, where the entries of its matrix
/// are among the values.
///
/// Shapes      places: count() x size x size
struct Sparsity {
  std::shared_ptr<const CsrPattern> pattern;
  std::vector<std::vector<int>> places;  ///< one vector for each kind of group
};

/// Built from adjacency, without a list of entries.
/// Requires    unknowns from 0 to `unknowns` - 1, each in some group
/// Throws      std::length_error where there are more entries than an int can count
/// Complexity  O(sum of size^2)
Sparsity make_sparsity(int unknowns, std::span<const Groups> kinds);

/// Adds a small matrix (size x size, row after row) to the values.
inline void scatter(std::span<const int> places, std::span<const double> small, std::span<double> values) {
  for (std::size_t k = 0; k < places.size(); ++k) values[static_cast<std::size_t>(places[k])] += small[k];
}

}  // namespace pliant
