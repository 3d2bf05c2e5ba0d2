// lib/pliant/ops/smooth_edge.h: new places for the inner control points of an edge or element (paper §5.2.4).
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit_options.h"
#include "pliant/ops/trial_patch.h"

namespace pliant {

/// Moves the inner control points of an unconstrained edge, one at a time, by optimal placement over the elements of
/// the edge; fields are refitted. Refuses (mesh unchanged) when nothing improves.
Outcome smooth_edge(Mesh& mesh, HalfEdgeId h, SmoothGoal goal, const RefitOptions& options = {});

/// The same for the inner control points of one element (none at p <= 2).
Outcome smooth_interior(Mesh& mesh, TriangleId t, SmoothGoal goal, const RefitOptions& options = {});

/// Scales the displacement of an unconstrained edge's inner control points from straight by `keep` (0: straight), and
/// blends the inner points of both elements from their edges; fields are refitted. Refuses where an element would not
/// be valid.
Outcome straighten_edge(Mesh& mesh, HalfEdgeId h, double keep, const RefitOptions& options = {});

/// Blends the inner control points of an element from its edges: each edge's displacement fades towards the opposite
/// corner (p <= 2: there are none).
Outcome blend_interior(Mesh& mesh, TriangleId t, const RefitOptions& options = {});

}  // namespace pliant
