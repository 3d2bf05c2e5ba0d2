// lib/pliant/mesh/triangle_tree.h: a tree of boxes that finds the elements whose control net's box contains a point.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// A packed tree: elements in Hilbert order of their boxes' centres, four to a node, four nodes to a node above, and so
/// on. It shows the mesh as it was when the tree was built.
///
/// Complexity  build: O(n log n), then about 47 bytes per triangle; a visit: expected O(log n)
class TriangleTree {
 public:
  /// Takes in all live elements, their boxes widened by `margin` on each side.
  void build(const Mesh& mesh, double margin);
  bool empty() const { return order_.empty(); }
  void clear() { *this = {}; }

  /// Calls visit(t) for elements whose boxes contain p, in the tree's order, until one call returns true.
  template <class Visit>
  void visit(const Point& p, Visit&& visit) const {
    if (empty()) return;
    struct Place {
      std::size_t level, index;
    };
    std::array<Place, 3 * max_levels + 4> stack{{{levels_.size() - 2, 0}}};
    for (std::size_t depth = 1; depth > 0;) {
      const auto [level, index] = stack[--depth];
      if (!boxes_[levels_[level] + index].contains(p)) continue;
      if (level == 0) {
        if (visit(order_[index])) return;
        continue;
      }
      const std::size_t below = levels_[level] - levels_[level - 1];
      for (std::size_t child = std::min(fanout * (index + 1), below); child-- > fanout * index;)
        stack[depth++] = {level - 1, child};
    }
  }

 private:
  static constexpr std::size_t fanout = 4, max_levels = 17;  // enough for 4^16 elements
  std::vector<TriangleId> order_;
  std::vector<Box> boxes_;           // boxes of the elements in order_, then of the nodes, level by level
  std::vector<std::size_t> levels_;  // where the boxes of each level begin, then where they end
};

}  // namespace pliant
