// lib/pliant/generate/refine_first_mesh.h: the first mesh of a boundary, refined to what it promises.
#pragma once
#include "pliant/improve/refine.h"

namespace pliant {

/// Refines a mesh that mesh_from_boundary has made. Then inner edges become straight where that leaves every element
/// valid (straighten_edges), and those beside curves share the bend of the curves (share_bends). With
/// mesh_from_boundary before it, this is what the tool bspline2mesh does.
///
/// The least angle that refinement was asked for becomes a criterion of the mesh, unless it has one already, so that
/// later passes keep that angle. The report is that of `refine`, with the counts of inner edges that became straight
/// or stayed curved, and of elements that share_bends changed.
/// Throws      as refine
PassReport refine_first_mesh(Mesh& mesh, const RefineOptions& options = {});

}  // namespace pliant
