// formats/msh/msh_field_writer.h: writes the fields of a mesh as sections $NodeData and $ElementNodeData.
#pragma once
#include <string>
#include <vector>

#include "formats/msh/msh_rows.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Writes each field: one view of 1, 3 or 9 components, or of each component one. Node p + 1 is point p, and element
/// t + 1 is triangle t.
///
/// Shapes      `order`: msh_net_order(mesh.degree); `used`: for each point whether the file has it as a node
/// Requires    check_structure(mesh) to be empty
/// Complexity  O(mesh) for each field
void write_msh_fields(const MeshData& mesh, const std::vector<int>& order, const std::vector<char>& used,
                      MshRows& rows);

/// How many bytes of a name Gmsh reads.
inline constexpr std::size_t msh_longest_name = 127;
/// A name as the format has it: in double quotes, without control characters, cut to `longest` bytes.
std::string msh_quoted(std::string name, std::size_t longest = msh_longest_name);

}  // namespace pliant
