// lib/pliant/mesh/check/lone_vertices.h: the mesh vertices where the boundary has a vertex in which no curve ends.
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

struct LoneVertex {
  int vertex;     ///< the vertex of the boundary complex
  PointId point;  ///< the nearest mesh vertex at its place, or none
};

/// The vertices of the boundary complex in which no curve ends, ascending. A mesh vertex is at the place of one if they
/// differ by at most 1e-12 of the mesh's size, or by four roundings of its largest coordinate if that is more.
///
/// Complexity  O(curves) where there are none, else O(mesh * log)
std::vector<LoneVertex> find_lone_vertices(const MeshData& data);
/// The same for a mesh with these points and triangles (as in MeshData).
std::vector<LoneVertex> find_lone_vertices(const BoundaryComplex& boundary, int degree, std::span<const Point> points,
                                           std::span<const PointId> triangles);

}  // namespace pliant
