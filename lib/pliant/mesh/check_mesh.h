// lib/pliant/mesh/check_mesh.h: lists every breach of the invariants M1, M2, M4, M5, M6, and apart from them of M3.
#pragma once
#include <span>
#include <vector>

#include "pliant/boundary/fault.h"
#include "pliant/geometry/validity/validity.h"
#include "pliant/mesh/half_edges.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// Faults in the sizes of arrays, ranges of indices and degrees, and numbers that are not finite. Every other question
/// about a document requires that there are none.
std::vector<Fault> check_arrays(const MeshData& data);

/// Faults of the boundary complex, then breaches of the structural invariants M1, M2, M4, M5, M6 (formats/mesh.md), at
/// most `limit` of each invariant.
///
/// Requires    check_arrays(data) to be empty
/// Complexity  O(data), plus sorting
std::vector<Fault> check_structure(const MeshData& data, int limit = 20);
/// The same, for a caller that has the half-edges of the document already.
std::vector<Fault> check_structure(const MeshData& data, const HalfEdges& half_edges, int limit = 20);

/// The corner of an element that lies at a cusp of the boundary, or none.
int cusp_corner(const BoundaryComplex& boundary, std::span<const Point> net);
/// The certificate of one element of a mesh with this boundary (M3). At a cusp of the boundary det J may be 0.
Validity certify_element(const BoundaryComplex& boundary, int degree, std::span<const Point> net);
Validity certify_element(const Mesh& mesh, TriangleId t);

/// Elements that break M3, by certificate.
struct InvalidElements {
  std::vector<TriangleId> invalid;
  std::vector<TriangleId> degenerate;
  bool empty() const { return invalid.empty() && degenerate.empty(); }
};
InvalidElements find_invalid(const Mesh& mesh);
InvalidElements find_invalid(const MeshData& data);

/// For tests: faults where the adjacency of a live mesh (twins, constraints, vertex half-edges, free slots) does not
/// agree with its nets; if it agrees, check_structure of its document.
std::vector<Fault> check_mesh(const Mesh& mesh);

}  // namespace pliant
