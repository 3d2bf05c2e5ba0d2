// tools/options/flow_file.h: the velocity field of another mesh document or series, from its file.
#pragma once
#include <string>
#include <vector>

#include "pliant/flow/mesh_flow.h"
#include "run/tool_options.h"

namespace pliant {

/// Is this argument of --flow a file? It is if it contains a "/", ends as files of meshes do (.json, .msh, .gz ...), or
/// names a file that exists, unless the part before a ":" is the name of a flow.
bool is_flow_file(const std::string& text);

/// The index of a field of two components; `what` it is, for the error.
/// Throws      InputError where there is none, or one by face that must not be
int find_vectors(const std::vector<Field>& fields, const std::string& name, const std::string& what,
                 bool may_be_by_face = false);

/// Reads every frame of the file that is the input of these options; what is said goes by them too.
/// Throws      Placed for bad input: faults of a mesh, invalid elements, no such field, times that do not increase;
///             std::system_error
VelocityField read_flow(const ToolOptions& options, const std::string& field, MeshFlow::Outside policy);

}  // namespace pliant
