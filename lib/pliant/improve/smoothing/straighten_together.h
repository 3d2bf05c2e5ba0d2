// lib/pliant/improve/smoothing/straighten_together.h: straightens bent edges at once that are in each other's way.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// Straightens an inner edge and, at once with it, the bent edges that are connected to it through elements with bent
/// edges. In a fan that has been sheared each edge bends round the next one; none can be straightened alone, though all
/// logical triangles are positive. Edges of elements that would not be valid keep their bend.
///
/// `is_bent` tells which edges are to be straightened. Returns true if any is; the mesh is unchanged otherwise. Fields
/// are refitted as TrialPatch::apply does.
///
/// Complexity  bounded: it stops at about 48 elements
bool straighten_together(Mesh& mesh, HalfEdgeId seed, bool (*is_bent)(const Mesh& mesh, HalfEdgeId h),
                         const RefitOptions& refit);

}  // namespace pliant
