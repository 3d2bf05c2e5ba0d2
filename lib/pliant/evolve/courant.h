// lib/pliant/evolve/courant.h: how long a velocity that the mesh carries takes to cross an element.
#pragma once
#include "pliant/mesh/mesh.h"

namespace pliant {

/// The least, over the elements, of the least height of the straight triangle on the corners, divided by the greatest
/// control value of the speed, which bounds the speed in the element. Infinite where nothing moves.
///
/// Units       time of the document
/// Requires    a field of two components that is not by face
/// Complexity  O(mesh)
double crossing_time(const Mesh& mesh, int field);

}  // namespace pliant
