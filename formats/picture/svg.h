// formats/picture/svg.h: a still picture of a mesh as SVG (formats/svg.md).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "formats/picture/coloring.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

struct SvgOptions {
  ColorBy color;
  const Colormap* map = colormaps().data();
  std::optional<ValueRange> range;  ///< otherwise that of the mesh
  std::optional<Box> box;           ///< what is shown, in mesh units; otherwise all control points and a margin
  double width = 1000;              ///< of the whole picture, in pixels
  int subdivide = 0;                ///< pieces of an element's edge for a field's colours; 0: as many as it takes
  double resolution = 1e-7;         ///< of numbers, as a part of the mesh's size
  double tolerance = 1e-5;          ///< of curves of degree above 3, as a part of the mesh's size
  bool edges = true;
  bool legend = true;
  bool control_net = false;
  std::vector<Circle> circles;
};

/// Appends the picture. Curves are exact for degrees 1 to 3 (lines, quadratic and cubic Bézier curves), numbers are
/// rounded to the resolution.
/// Requires    M1 and M2 (check_structure); the mesh may be tangled: elements that are not valid are marked
/// Throws      std::invalid_argument where the mesh has no such field (ElementValues)
void write_svg(const MeshData& mesh, const SvgOptions& options, std::string& out);

}  // namespace pliant
