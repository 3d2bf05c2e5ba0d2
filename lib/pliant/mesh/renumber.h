// lib/pliant/mesh/renumber.h: numbers that keep neighbours near in memory.
#pragma once
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Numbers triangles by where Hilbert's curve passes the mean of their corners; triangles in one cell of the curve keep
/// their order. Then numbers points in the order in which triangles name them; points that no triangle names come last
/// and keep their order.
///
/// Requires    check_arrays(data) to be empty
/// Complexity  O(data * log)
void renumber_along_hilbert(MeshData& data);

}  // namespace pliant
