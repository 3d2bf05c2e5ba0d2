// tools/evolve/start.h: where a simulation begins, or goes on.
#pragma once
#include <memory>
#include <string>

#include "evolve/evolve_options.h"
#include "evolve/frame_output.h"
#include "evolve/step.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The mesh that a simulation begins with, or the last one that an earlier run has written, and where frames go.
struct Start {
  MeshData mesh;            ///< checked, in its unit of length
  double first_time = 0;    ///< of the first frame
  bool is_resumed = false;  ///< the mesh is in the output already
  std::string text;         ///< of the document, if it is resumed
  std::unique_ptr<FrameOutput> output;
};

/// Throws      as reading a document does; UsageError where an earlier run had another step or other frames
Start find_start(const EvolveOptions& options, const Step& step);

/// Notes beside the output which step makes its frames, for `find_start` to compare.   Throws std::system_error
void note_step(const EvolveOptions& options, const Step& step);
/// Removes the note of an earlier run, before another one begins to write.
void forget_step(const EvolveOptions& options);

}  // namespace pliant
