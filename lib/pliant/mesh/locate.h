#pragma once  // lib/pliant/mesh/locate.h: the element and barycentric coordinates of a point (paper §5.2.1, §5.3.2)
#include <optional>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

struct Location {
  TriangleId triangle;
  Barycentric xi;
};

/// Finds elements by position. Holds a tree of control-net boxes, built at first need, for where the walk fails; it is
/// valid as long as the mesh does not change (construct anew, or call `forget_tree`).
class Locator {
 public:
  explicit Locator(const Mesh& mesh) : mesh_(mesh) {}
  /// The element that contains p; empty if p is outside the domain. Within 1e-12 of the size of an edge any of the
  /// elements there is right (at the outer boundary also "outside").
  ///
  /// Walk in the logical mesh from `hint`, then Newton in the element, then the neighbour that the most negative
  /// coordinate points at, with a visited set; where that fails, the tree and subdivision.
  std::optional<Location> find(const Point& p, TriangleId hint = none);
  /// Only the walk: empty if it fails, which says nothing about the domain.   Expected O(1) from a near hint
  std::optional<Location> walk(const Point& p, TriangleId hint);
  void forget_tree() { tree_.clear(); }

 private:
  struct Node {
    Box box;
    int first, last;  // a leaf's range in order_, or children
    bool leaf;
  };
  void build_tree();
  std::optional<Location> search_tree(const Point& p);
  const Mesh& mesh_;
  std::vector<Node> tree_;
  std::vector<TriangleId> order_;
};

}  // namespace pliant
