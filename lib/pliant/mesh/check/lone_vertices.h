// lib/pliant/mesh/check/lone_vertices.h: vertices of the boundary complex in which no curve ends, as vertices of a
// mesh.
#pragma once
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

struct LoneVertex {
  int vertex;     ///< of the boundary complex
  PointId point;  ///< the mesh vertex at its place; none where there is none
};

/// By their numbers in the complex. A mesh vertex is at its place if it is as near as M4 asks of curves: 1e-12 of the
/// mesh's size, or the spacing of the doubles there.
///
/// Complexity   O(curves) where there are none, else O(mesh * log)
std::vector<LoneVertex> find_lone_vertices(const MeshData& data);

}  // namespace pliant
