#pragma once  // lib/pliant/ops/remove_point.h: a vertex of degree three, and splits undone (paper §5.2.2)
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"

namespace pliant {

/// Removes an inner vertex of degree three that is on no curve: 3→1. Where the elements are a de Casteljau subdivision
/// the parent is restored, else projected.
Refusal remove_degree_three(Mesh& mesh, PointId v, const RefitOptions& options = {});

/// Removes any inner vertex that is on no curve: ears first (Devillers's order, each ear a flip), then 3→1; un-split
/// where it applies. Rolls back as a whole.
Refusal remove_inner_vertex(Mesh& mesh, PointId v, const RefitOptions& options = {});

struct CurveRemoval {
  Refusal refusal = Refusal::none;
  double error = 0;  ///< bound of the distance between old and new curve
};
/// Removes a vertex in the interior of a curve: knot removal with its footprint, 4→2 or 2→1 after the ears. Refused
/// when the curve's accumulated error would exceed `tolerance` (length).
CurveRemoval remove_curve_vertex(Mesh& mesh, PointId v, double tolerance, const RefitOptions& options = {});

}  // namespace pliant
