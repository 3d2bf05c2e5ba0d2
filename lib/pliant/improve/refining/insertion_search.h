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

  /// Walks in the logical mesh from t's centroid to p; the constrained edge that stands in the way, or none.
  HalfEdgeId walk_to(TriangleId t, const Point& p);
  /// The triangle at which the last walk ended.
  TriangleId reached() const { return reached_; }
  /// Of the constrained edges at the border of p's Delaunay cavity those in whose lens p lies; the nearest one, or
  /// none.
  HalfEdgeId find_encroached(TriangleId from, const Point& p);
  /// Below which barycentric coordinate a point of element k is taken to be on that edge: near an edge, compared with
  /// the nearest corner (at distance `nearest`), the edge itself is split, since slivers would not flip away at a
  /// curve.
  double edge_tolerance(TriangleId k, const Barycentric& xi, double nearest) const;

 private:
  const Mesh& mesh_;
  TriangleId reached_ = none;
  std::vector<TriangleId> cavity_;
};

/// From the chord of an edge to a vertex.
double distance_from_chord(const Mesh& mesh, HalfEdgeId h, PointId v);

/// From the chord of an edge to the nearer of the vertices opposite it.
double gap_over(const Mesh& mesh, HalfEdgeId h);

}  // namespace pliant
