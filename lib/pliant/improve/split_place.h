#pragma once  // lib/pliant/improve/split_place.h: where is an edge on a curve split best?
#include "pliant/improve/sharp_corners.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// The parameter, in (0, 1) along the half-edge, of a point that is on a shell around the end that is a sharp corner,
/// else as far from one end as from the other; nearer to one end where the logical triangles would be turned over
/// otherwise: a curve bends past vertices that stand close to it, and its chord does not.
double split_place(const Mesh& mesh, HalfEdgeId h, const SharpCorners& corners);

/// Logical triangles are turned over where a curve is far from its chord: the edge on a curve that bends most beside
/// those that hang together with t; none where t is not turned over, or nothing beside it bends.
HalfEdgeId curve_that_turns_over(const Mesh& mesh, TriangleId t);

}  // namespace pliant
