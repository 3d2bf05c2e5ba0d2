// formats/vtu/vtu_writer.h: writes a mesh as a VTK XML UnstructuredGrid, a series as a list of such files
// (formats/vtu.md).
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {
struct Metric;

struct VtuOptions {
  bool lagrange = false;               ///< Lagrange elements in place of Bézier ones
  bool curves = false;                 ///< constrained edges as cells too, behind the triangles
  std::vector<const Metric*> metrics;  ///< cell data; if there are any, `validity` too
};

/// Calls `write` with the file, part by part.
///
/// Units       those of the document, also if the mesh is in another (normalize_unit); metrics are right at any size
///             if it is normalised
/// Requires    M1, M2, M5 and M6 (check_structure); elements may be invalid
/// Complexity  O(mesh); the compressed file is in memory, and one array of points or values
void write_vtu(const MeshData& mesh, const VtuOptions& options, const std::function<void(std::string_view)>& write);

/// One file of a series.
struct PvdEntry {
  double time;
  std::string file;  ///< its name, relative to the list
};
/// The list of a series, a .pvd file. Times of frames should ascend: ParaView shows frames of one time together.
/// Requires    names in UTF-8 without control characters
std::string write_pvd(const std::vector<PvdEntry>& entries);

}  // namespace pliant
