// lib/pliant/flow/keep_cusps.h: keeps curves tangent to each other where they form a cusp.
#pragma once
#include "pliant/flow/move_curves.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// Makes the moved curves tangent again at the cusps of the boundary. A flow keeps two curves tangent, but their
/// interpolated motions turn them apart, by an angle of the order of the degree, or through each other. Of the two
/// tangents at the sides of a cusp one is turned onto the other, with its length; not that of a curve at rest. They
/// may differ by rounding, never so that the element between them is turned over.
///
/// Complexity  O(mesh) where there are cusps
void keep_cusps(const Mesh& mesh, MovedBoundary& boundary);

}  // namespace pliant
