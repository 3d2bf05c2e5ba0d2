// lib/pliant/flow/carried_velocity.h: a field of the mesh read as a velocity, also on the curves of the boundary.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// A continuous field of two components read as a velocity, in the (possibly scaled) lengths of the mesh. It holds
/// references into the mesh, which must not change.
class CarriedVelocity {
 public:
  /// Requires    a field of two components that is not by face
  /// Complexity  O(mesh)
  CarriedVelocity(const Mesh& mesh, int field);
  /// The same of control values that the mesh does not carry: two for each PointId, in the document's units.
  CarriedVelocity(const Mesh& mesh, std::span<const double> values);
  Vector at_point(PointId p) const;  ///< the control value at a control point; at a mesh vertex it is the velocity
  Vector at_vertex(int v) const;     ///< the velocity at a vertex of the boundary; 0 if no curve ends there
  Vector on_curve(CurveId c, double t) const;  ///< the velocity at a parameter of a curve

 private:
  /// The span that contains t. The end of a closed curve counts as its start.
  std::size_t span_at(CurveId c, double t) const;
  const Mesh& mesh_;
  std::span<const double> values_;              // two for each PointId
  std::vector<std::vector<double>> breaks_;     ///< the breaks of each curve
  std::vector<std::vector<HalfEdgeId>> spans_;  ///< for each curve and span a half-edge of its edge
  std::vector<PointId> vertices_;               ///< for each boundary vertex the mesh vertex there
};

}  // namespace pliant
