// lib/pliant/fem/solve/coarse_space.h: a space within that of the unknowns, for preconditioners of two levels.
#pragma once
#include <span>
#include <vector>

namespace pliant {

/// Functions in terms of those of the unknowns: unknown i has the weights from starts[i] to starts[i + 1].
struct CoarseSpace {
  int size = 0;  ///< how many functions
  std::vector<int> starts{0};
  std::vector<int> columns;
  std::vector<double> weights;

  int rows() const { return static_cast<int>(starts.size()) - 1; }
};

/// The hat functions of the vertices in the Bernstein basis of degree p, where they have the coefficients 0, 1/p,
/// ..., 1.
///
/// Shapes      `nets` has net_size(degree) unknowns for each triangle, in the order of NetLayout; -1 where the value is
///             given and no unknown. A vertex that is no unknown has no hat.
CoarseSpace hat_functions(int degree, std::span<const int> nets, int unknowns);

}  // namespace pliant
