#pragma once  // lib/pliant/boundary/check_boundary.h: is this boundary complex well-formed?
#include <vector>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/boundary/fault.h"

namespace pliant {

/// The structural faults: indices of vertices and faces, curve ends that differ from their vertices, closed curves with
/// ends, unnamed or doubly named faces, faces without a curve, curves without a face, loops that do not close (at every
/// vertex, each face's curves must chain), non-finite numbers. Places are JSON pointers relative to the boundary object
/// ("/curves/3/end"). A closed curve of one or two spans is legal here; in a mesh it has at least three (M2), and
/// `mesh_from_boundary` splits it.
std::vector<Fault> check_boundary(const BoundaryComplex& boundary);

/// The geometric ones, for a boundary that is to be meshed: curves that cross or touch other curves or themselves away
/// from common vertices, spans of zero length, wrong orientation of a face (its signed area by Green's theorem is not
/// positive), vertices at the same point, a derivative that vanishes. A cusp at a vertex is no fault. Names curves,
/// parameters, coordinates; at most 20 faults. Requires check_boundary to be empty.
/// Complexity  O(n log n + candidate pairs of span boxes), pairs decided by Bézier subdivision
std::vector<Fault> check_boundary_geometry(const BoundaryComplex& boundary);

}  // namespace pliant
