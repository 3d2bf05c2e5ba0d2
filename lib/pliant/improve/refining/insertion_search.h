// lib/pliant/improve/refining/insertion_search.h: what stands in the way of a point that refinement would insert (paper
// §5.3.2).
#pragma once
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// Looks around a place in the logical mesh, without changing anything.
class InsertionSearch {
 public:
  explicit InsertionSearch(const Mesh& mesh) : mesh_(mesh) {}

  /// Walks in the logical mesh from t's centroid towards p. Returns the constrained edge that stands in the way, or
  /// none.
  HalfEdgeId walk_to(TriangleId t, const Point& p);
  /// The triangle at which the last walk ended.
  TriangleId reached() const { return reached_; }
  /// The nearest of the constrained edges at the border of p's Delaunay cavity in whose protective lens p lies, or
  /// none. The cavity is sought from the triangle `from` on, which contains p.
  HalfEdgeId find_encroached(TriangleId from, const Point& p);
  /// The tolerance with which a point xi of triangle k is to be inserted: where a barycentric coordinate is below it,
  /// the point counts as being on that edge, and the edge is split. That is done where the point is much nearer to the
  /// edge than to the nearest corner (at distance `nearest`), since slivers at a curve would not flip away.
  double edge_tolerance(TriangleId k, const Barycentric& xi, double nearest) const;

 private:
  const Mesh& mesh_;
  TriangleId reached_ = none;
  std::vector<TriangleId> cavity_;
};

/// The distance of a vertex from the chord of an edge.
double distance_from_chord(const Mesh& mesh, HalfEdgeId h, PointId v);

/// The distance from the chord of an edge to the nearer of the vertices opposite it.
double gap_over(const Mesh& mesh, HalfEdgeId h);

}  // namespace pliant
