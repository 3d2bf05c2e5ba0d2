// lib/pliant/mesh/triangle_tree.h: the elements whose control net's box contains a point.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// A packed tree: elements in Hilbert order of their boxes' centres, four to a node, four nodes to one above, and so
/// on. It knows the mesh as it was when the tree was built.
///
/// Complexity  build: O(n log n) for the order, 43 bytes a triangle; a visit: expected O(log n)
class TriangleTree {
 public:
  /// All live elements, their boxes widened by `margin` on each side.
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
  static constexpr std::size_t fanout = 4, max_levels = 17;  // 4^16 elements
  std::vector<TriangleId> order_;
  std::vector<Box> boxes_;           // the elements' in order, then level by level
  std::vector<std::size_t> levels_;  // where each level's boxes begin, and the end
};

}  // namespace pliant
