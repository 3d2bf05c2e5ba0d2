// lib/pliant/geometry/node_basis.h: the Bernstein basis at the nodes of the rule that fits are integrated with.
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/quadrature.h"

namespace pliant {

/// The rule that is exact for products of two functions of one degree, and the basis at its nodes.
struct NodeBasis {
  std::span<const TriangleNode> nodes;
  std::vector<double> values;  ///< net_size a node
  int size = 0;

  std::span<const double> at(std::size_t node) const {
    const auto n = static_cast<std::size_t>(size);
    return std::span<const double>(values).subspan(node * n, n);
  }
};

/// Built once for each degree; thread-safe.
const NodeBasis& node_basis(int degree);

}  // namespace pliant
