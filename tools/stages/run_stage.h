// tools/stages/run_stage.h: one stage after the other on a mesh in memory, as a pipe of their tools.
#pragma once
#include "stages/stage.h"

namespace pliant {

/// Runs a stage that was checked. The report, and the text of what is thrown, are in the units of the document.
/// Requires    a mesh that meets what the stage needs, as one just read does
PassReport run_stage(const Stage& stage, Mesh& mesh, const StageContext& context);

/// Makes the mesh that `before` has left what `after` would read in a pipe, and checks what `before` does not ensure.
/// Throws      BadMesh where elements are not valid and `after` needs them so; as `reread`
void hand_over(Mesh& mesh, const Stage& before, const Stage& after);

}  // namespace pliant
