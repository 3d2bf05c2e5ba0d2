#pragma once  // lib/pliant/ops/smooth_edge.h: new places for the inner control points of an edge or element (paper
              // §5.2.4)
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"

namespace pliant {

enum class SmoothGoal { untangle, improve };

/// Moves the inner control points of an unconstrained edge, one at a time, by optimal placement over the elements of
/// the edge; fields are refitted. Refuses (mesh unchanged) when nothing improves.
Refusal smooth_edge(Mesh& mesh, HalfEdgeId h, SmoothGoal goal, const RefitOptions& options = {});

/// The same for the inner control points of one element (none at p <= 2).
Refusal smooth_interior(Mesh& mesh, TriangleId t, SmoothGoal goal, const RefitOptions& options = {});

}  // namespace pliant
