// lib/pliant/geometry/lattice.cpp: the lattice order of each degree, in one table per degree.
#include "pliant/geometry/lattice.h"

#include <cassert>
#include <cstddef>

#include "pliant/geometry/net_layout.h"

namespace pliant {

const std::vector<int>& lattice_order(int degree) {
  static const std::vector<std::vector<int>> all = [] {
    std::vector<std::vector<int>> orders;
    for (int p = 0; p <= max_net_degree; ++p) {
      const NetLayout& layout = NetLayout::of(p);
      std::vector<int> order;
      for (int n = 0; n < layout.size(); ++n) {
        const auto [i, j, k] = layout.exponents(n);
        order.push_back(lattice_index(j + k, k));
      }
      orders.push_back(order);
    }
    return orders;
  }();
  assert(0 <= degree && degree <= max_net_degree);
  return all[static_cast<std::size_t>(degree)];
}

}  // namespace pliant
