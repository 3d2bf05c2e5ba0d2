// formats/msh/msh_mesh.h: the steps from an MSH file to a mesh.
#pragma once
#include <string>
#include <vector>

#include "formats/msh/msh_file.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// An edge that must lie on a curve: it has one triangle, or separates two faces.
struct OpenEdge {
  HalfEdgeId left;   ///< the half-edge of its triangle; of two triangles, of the one whose face has the lower number
  HalfEdgeId right;  ///< the other triangle's half-edge; none on the outer boundary
};

// Both make the control points and nets of `mesh`, of degree mesh.degree, from the nodes: for elements of one order
// (msh_lagrange.cpp) and of several (msh_mixed.cpp).

/// Makes nets of node numbers, in the order of NetLayout.   Requires blocks of one order
void take_nets(MshFile& file, MeshData& mesh);
/// Raises all triangles to the highest order. New points come behind those of the file's nodes. Returns a warning if an
/// edge that two triangles share is not the same curve in both, otherwise an empty text.
std::string take_mixed_nets(MshFile& file, MeshData& mesh);

inline constexpr std::int32_t unused_point = -1;

/// The findings of one walk over all triangles.
struct EdgeFindings {
  std::vector<OpenEdge> open;
  std::vector<std::int32_t> uses;  ///< for each point: unused_point, or its use in the walk
  std::size_t clockwise = 0;       ///< triangles whose corners run clockwise
  std::size_t first_clockwise = 0;
};

/// Finds the edges that must lie on curves. With `convert` it also turns the Lagrange nodes of all nets into Bézier
/// control points; each edge is converted once and in one direction, so that both its triangles have the same bits.
EdgeFindings pair_edges(MeshData& mesh, bool convert);
/// A warning that names, by their tags, nodes of open edges that are at one place; empty if there are none.
std::string name_double_nodes(const MshFile& file, const MeshData& mesh, const std::vector<OpenEdge>& open);
/// For each half-edge the other triangle's half-edge between the same two vertices, in either direction; none if there
/// is no other triangle. Where three or more triangles share an edge, two are paired, and the others have none.
/// Complexity  O(half-edges) unless vertices have huge stars
std::vector<HalfEdgeId> twins_by_vertices(const MeshData& mesh);

/// Turns nets so that neighbours agree and every connected part has a positive area. Returns how many were turned.
std::size_t orient_triangles(MeshData& mesh);

/// Makes the chains of edges curves of the mesh's boundary, named after the lines of the file. Returns warnings.
std::vector<std::string> trace_curves(const MshFile& file, const std::vector<OpenEdge>& edges, MeshData& mesh);

/// The name as valid UTF-8. Bytes that are not UTF-8 are taken for Latin-1.
std::string msh_name(const std::string& bytes);

}  // namespace pliant
