// tools/options/frame_option.h: which mesh of a series a tool takes that writes only one.
#pragma once
#include <string>

#include "pliant/mesh/mesh_data.h"
#include "run/tool_options.h"

namespace pliant {

class FrameOption {
 public:
  void add(CLI::App& app);
  /// The mesh of the input that is wanted; its structure is sound, its elements may be tangled. A number from 0 on ends
  /// the reading behind that mesh.
  /// Throws      UsageError where the series is too short, InputError as for_each_mesh
  MeshData read(const ToolOptions& options) const;

 private:
  std::string wanted_ = "0";
};

}  // namespace pliant
