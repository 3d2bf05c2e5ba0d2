// lib/pliant/mesh/check_mesh.h: every breach of M1, M2, M4, M5, M6, by name; M3 apart.
#pragma once
#include <span>
#include <vector>

#include "pliant/boundary/fault.h"
#include "pliant/geometry/validity/validity.h"
#include "pliant/mesh/half_edges.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// Sizes of arrays, ranges of indices, finite numbers, degrees: what must hold before anything else can be asked.
std::vector<Fault> check_arrays(const MeshData& data);

/// The structural invariants M1, M2, M4, M5, M6 of a document whose arrays are well-formed. At most `limit` faults of
/// one kind are listed.   Complexity O(data)
std::vector<Fault> check_structure(const MeshData& data, int limit = 20);
/// The same with the half-edges of the document known.
std::vector<Fault> check_structure(const MeshData& data, const HalfEdges& half_edges, int limit = 20);

/// The certificate of one element of a mesh with this boundary: at a cusp's corner det J = 0 is forgiven (M3).
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

/// For tests: derived adjacency of a live mesh (twins, constraints, vertex half-edges, free slots) agrees with its
/// nets; then check_structure of its document.
std::vector<Fault> check_mesh(const Mesh& mesh);

}  // namespace pliant
