// tools/run/require_mesh.h: refuses meshes that break what a tool needs.
#pragma once
#include "pliant/mesh/mesh.h"

namespace pliant {

/// Throws BadMesh for the structural faults of the mesh and, unless it `accepts_tangled`, for its invalid elements.
void require_mesh(const MeshData& data, bool accepts_tangled);
/// Throws BadMesh for invalid elements alone, of a mesh whose structure is sound.
void require_valid(const Mesh& mesh);

}  // namespace pliant
