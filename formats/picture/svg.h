// formats/picture/svg.h: a still picture of a mesh as SVG (formats/svg.md).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "formats/picture/coloring.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Curves on which a field has one value each. Of a field with several components without a component it is the length.
struct IsolineRequest {
  std::string field;           ///< NAME or NAME.COMPONENT
  int count = 10;              ///< so many values, evenly within the range; not used if there are `values`
  std::vector<double> values;  ///< the values themselves
};

/// Arrows of a field with two components at the points of a square grid.
struct ArrowRequest {
  std::string field;
  int count = 24;  ///< points of the grid along the picture's longer side
};

struct SvgOptions {
  ColorBy color;
  const Colormap* map = nullptr;    ///< by default the theme's
  std::optional<ValueRange> range;  ///< the values of the first and last colour; by default the range of the mesh
  std::optional<Box> box;           ///< what is shown, in mesh units; by default all control points and a margin
  double width = 1000;              ///< width of the whole picture, in pixels
  double scale = 1;                 ///< of texts and lines
  int subdivide = 0;                ///< pieces of an element's edge for a field's colours; 0: as many as they need
  double resolution = 1e-7;         ///< numbers are rounded to this part of the size of mesh or box, the smaller one
  double tolerance =
      1e-5;  ///< how far isolines, and curves of degree above 3, may be off, as a part of the mesh's size
  std::string theme = "light";  ///< one of themes()
  std::string title;            ///< above the picture
  std::string unit;             ///< of lengths
  std::string color_unit;       ///< of what colours the elements; lengths and areas have it from `unit`
  bool edges = true;
  bool legend = true;
  bool axes = false;
  bool scale_bar = false;
  bool control_net = false;
  bool logical_mesh = false;
  std::vector<IsolineRequest> isolines;
  std::optional<ArrowRequest> arrows;
  std::vector<Circle> circles;
};

/// Appends the picture to `out`. Curves are exact for degrees 1 to 3 (lines, quadratic and cubic Bézier curves) apart
/// from numbers that are rounded to the resolution. Returns what was asked for and has no room, a sentence each.
/// Requires    M1 and M2 (check_structure); the mesh may be tangled: elements that are not valid are marked
/// Throws      std::invalid_argument where the mesh has no such field, or what is shown is too large; the text begins
///             with the option.
///             InputError where the mesh is too large or too small (require_document_size)
std::vector<std::string> write_svg(const MeshData& mesh, const SvgOptions& options, std::string& out);

}  // namespace pliant
