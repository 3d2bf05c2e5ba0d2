// lib/pliant/improve/smoothing/straighten_edges.h: makes inner edges as straight as the curves beside them allow.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct StraightenCounts {
  long straightened = 0;
  long left = 0;  ///< edges that cannot be straight
};
/// Makes unconstrained edges straight, with equally spaced control points, wherever the elements stay valid; an edge
/// that a curved neighbour keeps from being straight is tried again after that one. This is for new meshes: subdivision
/// has carried the bends of curves far into them, where they serve nothing.
///
/// Complexity  O(edges)
StraightenCounts straighten_edges(Mesh& mesh, const RefitOptions& options = {});

}  // namespace pliant
