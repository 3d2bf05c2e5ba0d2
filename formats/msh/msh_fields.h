// formats/msh/msh_fields.h: from the views of an MSH file to fields of the mesh.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "formats/msh/msh_file.h"
#include "formats/msh/msh_nodal_field.h"

namespace pliant {

struct MshViews {
  struct View {
    std::string name;
    bool by_face;
    MshNodalField values;
  };
  std::vector<View> views;
  double time = 0;
  std::vector<std::string> warnings;
  std::string no_step;  ///< as in MshImport
};

/// Reads one time step of each view, as values at nodes. Views that are no field of the mesh are left out with a
/// warning.
///
/// Requires    nets that are as the file has them, before triangles are turned; triangle_nodes in the file if and only
///             if orders are mixed
/// Throws      InputError for sections that break the format
/// Complexity  O(bytes of these sections + mesh) for each view with enough entries
MshViews read_views(const MshFile& file, const MeshData& mesh, std::optional<int> step);

}  // namespace pliant
