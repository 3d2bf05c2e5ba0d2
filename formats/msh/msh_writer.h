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

/// Appends a mesh to `out`. Control points become Lagrange nodes; faces become surfaces and curves become curves, each
/// in a physical group of its name; ends of open curves become points. Point p is node p + 1, and triangle t is element
/// t + 1. Fields become views. Criteria and knots have no place in the format, nor has the time of a mesh without
/// fields. `read_msh` reads the same mesh and fields back, to the rounding of values at nodes, but for the numbering.
///
/// Requires    check_structure(mesh) to be empty; elements may be tangled
/// Complexity  O(mesh)
void write_msh(const MeshData& mesh, const MshWriteOptions& options, std::string& out);

}  // namespace pliant
