// lib/pliant/improve/smoothing/share_bends.h: makes inner edges share the bend of the curves beside them.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct ShareCounts {
  long tried = 0, levelled = 0;  ///< elements
};
/// Moves the inner edges of elements so that det J varies less (level_jacobian), where the scaled Jacobian is below
/// `good`: first of the elements with an edge on a curve, then of those beside elements that have changed. A change is
/// kept where the least scaled Jacobian of the element and those beside it rises. Meant to follow straighten_edges.
///
/// Complexity  O(triangles) to find the elements on curves, then O(elements tried)
ShareCounts share_bends(Mesh& mesh, double good = 0.98, const RefitOptions& options = {});

}  // namespace pliant
