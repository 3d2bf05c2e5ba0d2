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

/// Finds elements by position: by a walk from an element nearby, or by a search in a tree of control-net boxes.
///
/// A point p that is found: chi(xi) was evaluated, and differs from p by no more than 1e-14 of the mesh's size, or
/// rounding; no coordinate of xi is below -1e-12. So a point outside the domain, but by no more than 1e-12 of an
/// element's size, may be found in that element.
///
/// A point that is outside: `find_in_element` proved that it is in none of the elements whose control net's box
/// contains it. If an element breaks M3 the proof may not end, and the element counts as not containing the point. A
/// point that is not finite is outside.
///
/// A point in several elements, up to 1e-12 in xi: the answer is the element with the least number of those that meet
/// there. Hints and earlier questions do not change it.
///
/// Requires    that the mesh does not change: the tree is made when first needed and kept. After a change call
///             `forget_tree` or construct anew; one thread at a time
class Locator {
 public:
  explicit Locator(const Mesh& mesh) : mesh_(mesh) {}
  /// The element that contains p; empty if p is outside the domain. A hint that is not a live triangle counts as none.
  ///
  /// Walks from the hint. Without a hint, or where that walk fails, it walks from the nearest of a few triangles, as
  /// long as there is no tree. It makes the tree when that walk fails too, or when all walks together have taken as
  /// many steps as making the tree costs.
  ///
  /// Complexity  expected O(1) from a near hint; without a hint about O(n^(1/3)), and O(log n) once there is a tree;
  ///             walks end after O(sqrt n) steps
  std::optional<Location> find(const Point& p, TriangleId hint = none);
  /// The same for many points: found[k] is what find(points[k]) gives. Takes the points in Hilbert order, with the
  /// element of each as the hint for the next.
  ///
  /// Shapes      found: as many as points
  /// Complexity  expected O(1) per point where there are as many points as triangles; about 8 MB of memory at most
  void find_all(std::span<const Point> points, std::span<std::optional<Location>> found);
  /// Only the walk: empty if it fails, which does not mean that p is outside. It goes through the logical mesh from
  /// `hint`, then tries Newton in the element where it ends; where xi has negative coordinates it goes on to the
  /// neighbour across the edge of the most negative one, to no element twice.
  ///
  /// Requires    a live triangle as the hint
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
  long steps_ = 0;          // how many steps all walks have taken since the last forget_tree
};

}  // namespace pliant
