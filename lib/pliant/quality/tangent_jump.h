// lib/pliant/quality/tangent_jump.h: how smooth are the boundary curves, and the mesh's edges on them?
#pragma once
#include <optional>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The largest angle (radians) between the one-sided tangents at breaks whose knot has a multiplicity below the
/// degree, of the splines of the boundary and of the mesh's edges on them (end legs of the control polygons of
/// consecutive spans). Empty if there are no such breaks. Where a tangent vanishes the angle does not exist and is left
/// out.
/// Requires    check_arrays(data) to be empty
std::optional<double> tangent_jump(const MeshData& data);

}  // namespace pliant
