// tools/evolve/step_count.h: the number of steps that a frame notes, where its time does not tell it.
#pragma once
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The number of steps that a frame notes in its member "evolve"; 0 if it notes none.
long noted_steps(const MeshData& mesh);
void note_steps(MeshData& mesh, long steps);

}  // namespace pliant
