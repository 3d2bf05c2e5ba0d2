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
  std::optional<ValueRange> range;  ///< the values of the first and last colour; by default the range of the mesh
  std::optional<Box> box;           ///< what is shown, in mesh units; by default all control points and a margin
  double width = 1000;              ///< width of the whole picture, in pixels
  int subdivide = 0;                ///< pieces of an element's edge for a field's colours; 0: as many as they need
  double resolution = 1e-7;         ///< numbers are rounded to this part of the mesh's size
  double tolerance = 1e-5;          ///< how far curves of degree above 3 may be off, as a part of the mesh's size
  bool edges = true;
  bool legend = true;
  bool control_net = false;
  std::vector<Circle> circles;
};

/// Appends the picture to `out`. Curves are exact for degrees 1 to 3 (lines, quadratic and cubic Bézier curves) apart
/// from numbers that are rounded to the resolution.
/// Requires    M1 and M2 (check_structure); the mesh may be tangled: elements that are not valid are marked
/// Throws      std::invalid_argument where the mesh has no such field (ElementValues)
void write_svg(const MeshData& mesh, const SvgOptions& options, std::string& out);

}  // namespace pliant
