// lib/pliant/ops/smooth_edge.h: new places for the inner control points of an edge or element (paper §5.2.4).
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit_options.h"
#include "pliant/ops/trial_patch.h"

namespace pliant {

/// Moves the control points inside an unconstrained edge, one at a time, by optimal placement over the two elements of
/// the edge; fields are refitted.
///
/// Refuses     where no point moves (would_invert); where valid elements would not stay valid
Outcome smooth_edge(Mesh& mesh, HalfEdgeId h, SmoothGoal goal, const RefitOptions& options = {});

/// The same for the inner control points of one element; refused as not_removable at p <= 2, where there are none.
Outcome smooth_interior(Mesh& mesh, TriangleId t, SmoothGoal goal, const RefitOptions& options = {});

/// Scales the distance of the control points inside an unconstrained edge from their straight places by `keep` (0: the
/// edge becomes straight), and blends the inner points of both elements (see blend_interior); fields are refitted.
///
/// Refuses     where an element would not be valid
Outcome straighten_edge(Mesh& mesh, HalfEdgeId h, double keep, const RefitOptions& options = {});

/// Blends the inner control points of an element from its edges: each is displaced from its straight place as the edges
/// are, and the displacement of an edge fades towards the opposite corner.
///
/// Refuses     p <= 2, where there are none (not_removable); where the element would not be valid
Outcome blend_interior(Mesh& mesh, TriangleId t, const RefitOptions& options = {});

}  // namespace pliant
