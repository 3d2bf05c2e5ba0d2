// lib/pliant/boundary/check_boundary.h: is this boundary complex well-formed?
#pragma once
#include <vector>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/boundary/fault.h"

namespace pliant {

/// The structural faults: wrong indices of vertices and faces, curve ends that differ from their vertices, closed
/// curves with ends, faces without a name or with another's name, faces without a curve, curves without a face, loops
/// that do not close (at every vertex, the curves of each face must chain), numbers that are not finite. Places are
/// JSON pointers relative to the boundary object ("/curves/3/end"). A closed curve of one or two spans is no fault
/// here; in a mesh it has at least three (M2), and `mesh_from_boundary` splits it.
std::vector<Fault> check_boundary(const BoundaryComplex& boundary);

/// The geometric faults of a boundary that is to be meshed: curves that cross or touch other curves or themselves away
/// from common vertices (invariant "contact"), spans of zero length, vertices at the same point or on a curve that does
/// not end there, a derivative that vanishes. A cusp at a vertex is no fault. The text names curves, parameters and
/// coordinates, and says what would be right; there are at most 20 faults.
///
/// Requires    check_boundary finds nothing
/// Complexity  O(n log n + pairs of spans whose boxes overlap); each pair is decided by Bézier subdivision
std::vector<Fault> check_boundary_geometry(const BoundaryComplex& boundary);

/// The curves whose `left` or `right` is not the face that lies there. To find the face beside a curve, a ray is
/// followed outwards from there: each curve that it crosses enters one face and leaves another. In the end one face
/// counts once, or none does, outside of the domain. A face on the wrong side of all curves that bound it is one fault.
/// The text names curves, parameters and coordinates; there are at most some 20 faults.
///
/// Requires    check_boundary and check_boundary_geometry find nothing
/// Complexity  O((spans + curves) * sqrt(spans)) if spans are short compared with the boundary
std::vector<Fault> check_boundary_sides(const BoundaryComplex& boundary);

}  // namespace pliant
