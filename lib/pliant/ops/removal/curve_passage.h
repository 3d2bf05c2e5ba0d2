// lib/pliant/ops/removal/curve_passage.h: the curve through a vertex, and what the removal of its knot touches.
#pragma once
#include <vector>

#include "pliant/mesh/star.h"
#include "pliant/ops/removal/merge.h"

namespace pliant {

/// The two edges of the one curve that passes through a vertex, each as one of its half-edges.
struct Passage {
  CurveId curve = none;
  HalfEdgeId before = none;  // the edge that ends at the vertex, in the curve's direction
  HalfEdgeId after = none;   // the edge that starts there
};
/// The passage at v; its curve is none if v is on no curve, a corner, a lone vertex, or pinched.
Passage passage_at(const Mesh& mesh, PointId v, const Star& star);

/// Everything that knot removal moves, and by how much.
struct Footprint {
  std::vector<ConstraintId> edges;     // edges on the curve, without the two that merge
  std::vector<HalfEdgeId> half_edges;  // one half-edge of each
  std::vector<PointId> moved;          // vertices that move
  std::vector<Vector> shifts;          // by how much each moves
  std::vector<TriangleId> triangles;   // triangles that contain a moved point

  Vector shift_of(PointId p) const {
    for (std::size_t k = 0; k < moved.size(); ++k)
      if (moved[k] == p) return shifts[k];
    return {};
  }
};
/// Finds the edges of the footprint: beyond the two that merge, on either side degree + `more` edges along the curve.
void find_footprint(const Mesh& mesh, const Passage& passage, Footprint& footprint, int more = 0);

/// Finds the fan of a vertex on one side of its curve, from half-edge `first` on: link vertices counter-clockwise, from
/// one neighbour on the curve to the other.
void find_fan(const Mesh& mesh, const Star& star, HalfEdgeId first, Fan& fan);

}  // namespace pliant
