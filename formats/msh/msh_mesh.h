// formats/msh/msh_mesh.h: the steps from an MSH file to a mesh.
#pragma once
#include <string>
#include <vector>

#include "formats/msh/msh_file.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// An edge that must lie on a curve: it has one triangle, or separates two faces.
struct OpenEdge {
  HalfEdgeId left;   ///< its triangle; of two the one whose face has the lower number
  HalfEdgeId right;  ///< none on the outer boundary
};

// Elements of one order (msh_lagrange.cpp), or of several (msh_mixed.cpp): control points and nets of `mesh`, of degree
// mesh.degree, from the nodes.

/// Nets of node numbers in the order of NetLayout.   Requires blocks of one order
void take_nets(MshFile& file, MeshData& mesh);
/// Raises all triangles to the highest order. Points behind those of the file's nodes are new. Returns a warning where
/// edges that two triangles share are not the same curve in both, otherwise an empty text.
std::string take_mixed_nets(MshFile& file, MeshData& mesh);

inline constexpr std::int32_t unused_point = -1;

/// What one walk over all triangles finds.
struct EdgeFindings {
  std::vector<OpenEdge> open;
  std::vector<std::int32_t> uses;  ///< for each point: unused_point, or what it serves for in the walk
  std::size_t clockwise = 0;       ///< triangles whose corners run clockwise
  std::size_t first_clockwise = 0;
};

/// Finds the edges that must lie on curves, and with `convert` turns the Lagrange nodes of all nets into Bézier control
/// points, each edge once, in one direction, so that both its triangles see the same bits.
EdgeFindings pair_edges(MeshData& mesh, bool convert);
/// A warning that names nodes at one place on open edges, by their tags; empty where there are none.
std::string name_double_nodes(const MshFile& file, const MeshData& mesh, const std::vector<OpenEdge>& open);
/// The other triangle's half-edge between the same two vertices, in whichever direction; none where there is none.
/// Where three and more triangles share an edge, two are paired, and the others are their own.
/// Complexity  O(half-edges) unless vertices have huge stars
std::vector<HalfEdgeId> twins_by_vertices(const MeshData& mesh);

/// Turns nets so that neighbours agree and every connected part has a positive area; returns how many.
std::size_t orient_triangles(MeshData& mesh);

/// Makes the chains of edges curves of the mesh's boundary, named after the lines of the file. Returns warnings.
std::vector<std::string> trace_curves(const MshFile& file, const std::vector<OpenEdge>& edges, MeshData& mesh);

/// A name as valid UTF-8 (what is not UTF-8 is taken for Latin-1).
std::string msh_name(const std::string& bytes);

}  // namespace pliant
