// formats/msh/msh_writer.h: writes Gmsh's MSH files, versions 4.1 and 2.2, text and binary (formats/msh.md).
#pragma once
#include <string>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

struct MshWriteOptions {
  enum class Version { v4_1, v2_2 };
  Version version = Version::v4_1;
  bool binary = false;
};

/// The geometry of a mesh: control points become Lagrange nodes; faces become surfaces and curves curves, each in a
/// physical group of its name; ends of open curves become points. Appended to `out`; read back (`read_msh`) it is the
/// same mesh, to the rounding of its nodes, but for the numbering: node tag - 1 is the point, element tag - 1 the
/// triangle. Time, fields, criteria and knots have no place there.
///
/// Requires    check_structure(mesh) to be empty; tangled elements may be among them
/// Complexity  O(mesh)
void write_msh(const MeshData& mesh, const MshWriteOptions& options, std::string& out);

}  // namespace pliant
