// lib/pliant/ops/removal/curve_passage.h: the curve through a vertex, and what the removal of its knot touches.
#pragma once
#include <vector>

#include "pliant/mesh/star.h"
#include "pliant/ops/removal/merge.h"

namespace pliant {

/// The two edges of the one curve that passes through a vertex; half-edges of either side.
struct Passage {
  CurveId curve = none;
  HalfEdgeId before = none, after = none;  // edge that ends at v, edge that starts there (in the curve's direction)
};
/// Without a curve where the vertex is on none, at a corner, or pinched.
Passage passage_at(const Mesh& mesh, PointId v, const Star& star);

/// Everything that knot removal moves, and by how much.
struct Footprint {
  std::vector<ConstraintId> edges;     // but the two that merge
  std::vector<HalfEdgeId> half_edges;  // one of each
  std::vector<PointId> moved;          // vertices
  std::vector<Vector> shifts;
  std::vector<TriangleId> triangles;  // that contain a moved point

  Vector shift_of(PointId p) const {
    for (std::size_t k = 0; k < moved.size(); ++k)
      if (moved[k] == p) return shifts[k];
    return {};
  }
};
/// The edges beyond the two that merge, as many as the degree on either side, and `more`.
void find_footprint(const Mesh& mesh, const Passage& passage, Footprint& footprint, int more = 0);

/// The fan of v on one side: link vertices counter-clockwise from one curve neighbour to the other.
void find_fan(const Mesh& mesh, const Star& star, HalfEdgeId first, Fan& fan);

}  // namespace pliant
