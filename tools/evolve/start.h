// tools/evolve/start.h: where a simulation begins, or goes on.
#pragma once
#include <memory>
#include <string>

#include "evolve/evolve_options.h"
#include "evolve/frame_output.h"
#include "evolve/step.h"
#include "formats/document/document_form.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The mesh that a simulation begins with, or goes on from, which then is a frame that an earlier run has written.
struct Start {
  DocumentForm form = DocumentForm::json;  ///< of the document that it was read from
  MeshData mesh;                           ///< checked, in its unit of length
  double first_time = 0;                   ///< of the first frame
  bool is_resumed = false;                 ///< the mesh is in the output already
  bool is_past_end = false;                ///< the mesh is later than this run is to end, so that nothing is to be done
  bool is_steady = false;  ///< the run before ended with this mesh, which changes no more than --until-steady allows
  std::string text;        ///< of the document, if it is resumed
  std::unique_ptr<EarlierFrames> earlier;  ///< if it is resumed
  long kept = 0;                           ///< so many of the earlier frames stay
};

/// Reads; nothing is written or removed.
/// Throws      as reading a document does; UsageError where an earlier run had another step or other frames
Start find_start(const EvolveOptions& options, const Step& step);

/// A time with 12 digits, for messages.
std::string text_of(double value);

}  // namespace pliant
