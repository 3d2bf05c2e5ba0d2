// formats/picture/svg/drawing.h: the layers of a picture that are drawn in the coordinates of the mesh.
#pragma once
#include <string>
#include <vector>

#include "formats/picture/mesh_edges.h"
#include "formats/picture/svg.h"
#include "formats/picture/svg/path.h"
#include "formats/picture/svg/placement.h"
#include "formats/picture/svg/theme.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/mesh/check_mesh.h"

namespace pliant {

/// One mesh and all that its layers need.
struct Drawing {
  const MeshData& mesh;
  const SvgOptions& options;
  const Theme& theme;
  const Colormap& map;
  const ElementValues& values;
  ValueRange range;
  const InvalidElements& bad;
  const MeshEdges& edges;
  const Box& box;  ///< what is shown
  const Placement& placement;
  double size;   ///< of the mesh or of what is shown, whichever is smaller: what rounding and tolerance are parts of
  double pixel;  ///< size of a pixel in mesh units

  TriangleId triangles() const { return static_cast<TriangleId>(mesh.triangle_faces.size()); }
  const Point& at(PointId p) const { return mesh.points[static_cast<std::size_t>(p)]; }
  /// The colour of the element at a point of it.
  Rgb color_at(TriangleId t, const Barycentric& xi) const;
  /// A path writer with the drawing's size, resolution and tolerance.
  SvgPath path(std::string& out) const;
  /// ` stroke-width="…"` for a width in pixels, before the theme's factor.
  std::string stroke_width(double pixels) const;
  /// The width of lines between elements: thinner where elements are small, or a fine mesh would be nothing but lines.
  double fine_width() const;
};

/// Writes the closed boundary of an element as path data.
void write_outline(int degree, const std::vector<Point>& net, SvgPath& path);

void draw_circles(const Drawing& drawing, std::string& out);
void draw_elements(const Drawing& drawing, std::string& out);
void draw_marks(const Drawing& drawing, std::string& out);
void draw_inner_edges(const Drawing& drawing, std::string& out);
void draw_curves(const Drawing& drawing, std::string& out);
void draw_control_net(const Drawing& drawing, std::string& out);
void draw_logical_mesh(const Drawing& drawing, std::string& out);

}  // namespace pliant
