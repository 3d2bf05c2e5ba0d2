// lib/pliant/boundary/check_boundary.h: is this boundary complex well-formed?
#pragma once
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
/// from common vertices (invariant "contact"), spans of zero length, vertices at the same point or on a curve that does
/// not end there, a derivative that vanishes. A cusp at a vertex is no fault. Names curves, parameters, coordinates,
/// and what would be right; at most 20 faults. Requires check_boundary to be empty. Complexity  O(n log n + candidate
/// pairs of span boxes), pairs decided by Bézier subdivision
std::vector<Fault> check_boundary_geometry(const BoundaryComplex& boundary);

/// Curves whose `left` or `right` is not the face that lies there. What lies beside a curve is counted on a ray from
/// it: each curve that the ray crosses enters one face and leaves another, so in the end one face counts once, or,
/// outside of the domain, none. A face that lies on the wrong side of several curves, all that bound it, is one fault.
/// Names curves, parameters, coordinates; at most some 20 faults. Requires check_boundary and check_boundary_geometry
/// to be empty. Complexity  O((spans + curves) * sqrt(spans)) for spans that are short beside the boundary
std::vector<Fault> check_boundary_sides(const BoundaryComplex& boundary);

}  // namespace pliant
