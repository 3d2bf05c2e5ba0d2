// formats/msh/msh_views.h: which sections with values belong together, as steps of one view.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "formats/msh/msh_file.h"

namespace pliant {

/// Sections of one kind and name: the sections of each time step, by the number that the file gives to the step.
struct MshView {
  std::string name;
  std::map<std::int32_t, std::vector<const MshDataSection*>> steps;
};

/// Sorts the sections into views as Gmsh does: a second section of the same name, kind, step and partition begins
/// another view of that name.   Complexity  O(n log n) for n sections
std::vector<MshView> group_views(const MshFile& file);

}  // namespace pliant
