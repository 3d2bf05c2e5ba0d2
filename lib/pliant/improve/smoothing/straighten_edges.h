// lib/pliant/improve/smoothing/straighten_edges.h: inner edges as straight as the curves beside them allow.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct StraightenCounts {
  long straightened = 0;
  long left = 0;  ///< that cannot be straight
};
/// Makes unconstrained edges straight, with equally spaced control points, wherever the elements stay valid; an edge
/// that has to stay curved because of a neighbour is tried again after it. Subdivision carries the bend of a curve far
/// into the mesh, where it serves nothing: this is for meshes that are new.
///
/// Complexity  O(edges), most of them looked at only
StraightenCounts straighten_edges(Mesh& mesh, const RefitOptions& options = {});

}  // namespace pliant
