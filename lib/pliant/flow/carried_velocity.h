// lib/pliant/flow/carried_velocity.h: the velocity that a mesh carries as a field, seen from its boundary.
#pragma once
#include <cstddef>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// A continuous field of two components read as a velocity. Holds references into the mesh, which must not change.
class CarriedVelocity {
 public:
  /// Requires a field of two components that is not by face.   Complexity O(mesh)
  CarriedVelocity(const Mesh& mesh, int field);
  Vector at_point(PointId p) const;  ///< the control value; the velocity itself at a vertex
  Vector at_vertex(int v) const;     ///< at a vertex of the boundary
  Vector on_curve(CurveId c, double t) const;

 private:
  /// The span that contains t; a closed curve's end is its start.
  std::size_t span_at(CurveId c, double t) const;
  const Mesh& mesh_;
  const Field& field_;
  std::vector<std::vector<double>> breaks_;     ///< by curve
  std::vector<std::vector<HalfEdgeId>> spans_;  ///< curve, span -> its edge
  std::vector<PointId> vertices_;               ///< boundary vertex -> mesh vertex
};

}  // namespace pliant
