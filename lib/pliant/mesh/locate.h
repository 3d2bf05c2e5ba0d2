// lib/pliant/mesh/locate.h: the element and barycentric coordinates of a point (paper §5.2.1, §5.3.2).
#pragma once
#include <optional>
#include <span>

#include "pliant/mesh/mesh.h"
#include "pliant/mesh/triangle_tree.h"

namespace pliant {

struct Location {
  TriangleId triangle;
  Barycentric xi;
};

/// Finds elements by position: by a walk from near, by a tree of control-net boxes from afar. What is proved:
///   found     |chi(xi) - p| is within 1e-14 of the mesh's size and rounding, by evaluation, with no coordinate of xi
///             below -1e-12; so a point at most 1e-12 of its element's size outside the domain may be found
///   outside   no element contains p (M3 is required only to bound the work): for each whose control net's box contains
///             p, bisection proved that it does not (`find_in_element`); what an element that breaks M3 leaves
///             undecided counts as outside
/// Where several elements contain p, up to 1e-12 of xi, the answer is the least of those around, so it depends neither
/// on hints nor on what was asked before. Non-finite points are outside.
///
/// The tree is made at the first need, and the answers from it hold as long as the mesh does not change: construct anew
/// or call `forget_tree` then. Not for use by two threads at once.
class Locator {
 public:
  explicit Locator(const Mesh& mesh) : mesh_(mesh) {}
  /// The element that contains p; empty if p is outside the domain. A hint that is not a live triangle counts as none.
  ///
  /// Walks from the hint; without one, or where that fails, from the nearest of a few triangles as long as there is no
  /// tree. The tree is made when that fails too, and once all walks have taken as many steps as making it is worth.
  ///
  /// Complexity  expected O(1) from a near hint; without, some O(n^(1/3)), and O(log n) once there is a tree; walks end
  ///             after O(sqrt n) steps
  std::optional<Location> find(const Point& p, TriangleId hint = none);
  /// The same for many points: found[k] is what find(points[k]) gives. Takes them in Hilbert order, each with the one
  /// before as its hint.
  ///
  /// Shapes      found: as many as points
  /// Complexity  expected O(1) a point where there are as many points as triangles; 8 bytes for each of 2^20 points
  void find_all(std::span<const Point> points, std::span<std::optional<Location>> found);
  /// Only the walk: empty if it fails, which says nothing about the domain. In the logical mesh from `hint`, then
  /// Newton in the element, then the neighbour that the most negative coordinate points at, with a visited set.
  ///
  /// Complexity  expected O(1) from a near hint; never more than O(sqrt n) steps
  std::optional<Location> walk(const Point& p, TriangleId hint);
  void forget_tree() {
    tree_.clear();
    steps_ = 0;
  }

 private:
  std::optional<Location> walk(const Point& p, TriangleId hint, long most_steps);
  std::optional<Location> walk_or_search(const Point& p, TriangleId hint);
  std::optional<Location> search_tree(const Point& p);
  TriangleId nearest_of_some(const Point& p);
  Location least_around(const Point& p, const Location& found) const;
  TriangleId walk_logical(const Point& p, TriangleId t, long most_steps);
  std::optional<Barycentric> invert(TriangleId t, const Point& p) const;
  std::optional<Barycentric> search(TriangleId t, const Point& p) const;
  double tolerance(const Point& p) const;
  bool is_triangle(TriangleId t) const { return t >= 0 && t < mesh_.triangle_slots() && mesh_.is_alive(t); }
  long most_steps() const;

  const Mesh& mesh_;
  TriangleTree tree_;
  TriangleId last_ = none;  // where the last point was found: the hint for the next of many
  long steps_ = 0;          // of all walks since there is no tree
};

}  // namespace pliant
