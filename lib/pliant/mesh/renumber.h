// lib/pliant/mesh/renumber.h: numbers that keep neighbours near in memory.
#pragma once
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Numbers triangles along Hilbert's curve through their corners' means, those in one cell of it as before, and points
/// in the order in which triangles name them. Points that no triangle names come last, as before.
/// Requires well-formed arrays. Complexity O(data * log)
void renumber_along_hilbert(MeshData& data);

}  // namespace pliant
