// lib/pliant/geometry/node_basis.h: the Bernstein basis at the nodes of the quadrature rule for least-squares fits.
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/quadrature.h"

namespace pliant {

/// The quadrature rule that is exact for products of two polynomials of the same degree, and their basis at its nodes.
struct NodeBasis {
  std::span<const TriangleNode> nodes;
  std::vector<double> values;  ///< `size` values for each node, node after node
  int size = 0;                ///< how many basis functions there are

  /// The values of all basis functions at one node.
  std::span<const double> at(std::size_t node) const {
    const auto n = static_cast<std::size_t>(size);
    return std::span<const double>(values).subspan(node * n, n);
  }
};

/// The table for one degree, built once; thread-safe.
const NodeBasis& node_basis(int degree);

}  // namespace pliant
