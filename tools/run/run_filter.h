// tools/run/run_filter.h: a whole mesh-to-mesh tool around one stage.
#pragma once
#include "stages/stage.h"

namespace pliant {

/// Adds the stage's options and the common ones, parses, checks, and maps the stage over the series: reads each
/// document, checks it (structure; validity unless the stage accepts tangled meshes), makes the Mesh, runs the stage,
/// writes the mesh, and then its report. Nothing of a mesh in which the stage throws is written. Returns the exit
/// status.
int run_filter(Stage& stage, int argc, char** argv);

}  // namespace pliant
