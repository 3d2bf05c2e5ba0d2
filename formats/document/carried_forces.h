// formats/document/carried_forces.h: the forces on curves that a mesh document carries (its member `navierstokes`).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pliant/boundary/extra_members.h"
#include "pliant/geometry/point.h"

namespace pliant {

/// The force of the fluid on the curves of this name; empty where none is noted.
/// Throws      InputError with a pointer where the member is not as formats/mesh.md has it
std::optional<Vector> carried_force(const ExtraMembers& extra, const std::string& curve);
/// The names of the curves with a force.   Throws as carried_force
std::vector<std::string> curves_with_force(const ExtraMembers& extra);

}  // namespace pliant
