// lib/pliant/geometry/node_basis.cpp: the Bernstein basis at the nodes of the quadrature rule for least-squares fits.
#include "pliant/geometry/node_basis.h"

#include <array>
#include <mutex>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {

const NodeBasis& node_basis(int degree) {
  static std::array<std::once_flag, max_degree + 1> built;
  static std::array<NodeBasis, max_degree + 1> tables;
  const auto k = static_cast<std::size_t>(degree);
  std::call_once(built[k], [degree, &table = tables[k]] {
    table.nodes = triangle_rule(2 * degree);
    table.size = net_size(degree);
    const auto n = static_cast<std::size_t>(table.size);
    table.values.resize(table.nodes.size() * n);
    for (std::size_t node = 0; node < table.nodes.size(); ++node)
      bernstein_basis(degree, table.nodes[node].xi, std::span<double>(table.values).subspan(node * n, n));
  });
  return tables[k];
}

}  // namespace pliant
