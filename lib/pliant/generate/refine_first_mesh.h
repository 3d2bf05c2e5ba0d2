// lib/pliant/generate/refine_first_mesh.h: the first mesh of a boundary, refined to what it promises.
#pragma once
#include "pliant/improve/refine.h"

namespace pliant {

/// Refines a mesh that mesh_from_boundary has made, then makes its inner edges straight where that leaves every element
/// valid. The least angle is written into the mesh's criteria, so that later passes keep it. With mesh_from_boundary
/// before it, this is what the tool bspline2mesh does.
///
/// The report is that of `refine` with the counts of edges straightened, or left curved, and elements levelled behind
/// it.
/// Throws      as refine
PassReport refine_first_mesh(Mesh& mesh, const RefineOptions& options = {});

}  // namespace pliant
