// lib/pliant/improve/smoothing/share_bends.h: the bend of curves, shared with the elements beside them.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct ShareCounts {
  long tried = 0, levelled = 0;
};
/// Where an element on a curve, or beside one that was levelled, has a scaled Jacobian below `good`, its inner edges
/// are moved so that det J varies less (level_jacobian); kept where the least scaled Jacobian of it and the elements
/// beside rises by it. Meant to follow straighten_edges.
///
/// Complexity  O(triangles) to find the curves, then O(elements tried)
ShareCounts share_bends(Mesh& mesh, double good = 0.98, const RefitOptions& options = {});

}  // namespace pliant
