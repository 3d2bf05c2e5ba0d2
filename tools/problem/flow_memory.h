// tools/problem/flow_memory.h: what a flow's step leaves in the mesh document beside fields: its member `navierstokes`.
#pragma once
#include <map>
#include <optional>
#include <string>

#include "pliant/mesh/mesh.h"

namespace pliant {

struct FlowMemory {
  std::optional<double> dt;              ///< the length of the last step
  std::map<std::string, Vector> forces;  ///< of the fluid, by the names of curves
};

/// Throws      InputError where the member is not what `remember` writes
FlowMemory recall(const Mesh& mesh);
void remember(Mesh& mesh, const FlowMemory& memory);

}  // namespace pliant
