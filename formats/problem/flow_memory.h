// formats/problem/flow_memory.h: what a flow's step leaves in the mesh document beside fields: its member
// `navierstokes`.
#pragma once
#include <map>
#include <optional>
#include <string>

#include "pliant/boundary/extra_members.h"
#include "pliant/geometry/point.h"

namespace pliant {

struct FlowMemory {
  std::optional<double> dt;              ///< the length of the last step
  std::map<std::string, Vector> forces;  ///< of the fluid, by the names of curves
};

/// Throws      InputError where the member is not what `remember` writes (formats/mesh.md)
FlowMemory recall_flow(const ExtraMembers& extra);
void remember_flow(ExtraMembers& extra, const FlowMemory& memory);

}  // namespace pliant
