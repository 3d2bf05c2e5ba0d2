// lib/pliant/quality/tangent_jump.h: measures how smooth the boundary curves are, and the mesh edges on them.
#pragma once
#include <optional>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The largest angle (radians) between the two one-sided tangents at a break whose knot has a multiplicity below the
/// degree: tangents of the boundary's splines, and of the mesh edges that meet there (the end legs of their control
/// polygons). Where a tangent vanishes there is no angle. Empty if there is no angle at all.
///
/// Requires    check_arrays(data) to be empty
std::optional<double> tangent_jump(const MeshData& data);

}  // namespace pliant
