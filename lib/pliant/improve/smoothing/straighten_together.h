// lib/pliant/improve/smoothing/straighten_together.h: bent edges that are in each other's way become straight at once.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// Straightens an inner edge together with the bent ones that hang together with it, element by element, at once: in a
/// fan that has been sheared each edge bends round the next, and none can be straightened alone, though all straight
/// triangles are positive. Edges of elements that would not be valid keep their bend. `is_bent` tells which edges are
/// to be straightened. True if any is; the mesh is unchanged otherwise. Fields: TrialPatch::apply.
///
/// Complexity  bounded: so many elements are looked at, the nearest ones
bool straighten_together(Mesh& mesh, HalfEdgeId seed, bool (*is_bent)(const Mesh& mesh, HalfEdgeId h),
                         const RefitOptions& refit);

}  // namespace pliant
