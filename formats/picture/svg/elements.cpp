// formats/picture/svg/elements.cpp: the fill of elements, by face, metric or field, and the marks of bad ones.
#include <algorithm>
#include <cmath>
#include <map>

#include "formats/picture/svg/drawing.h"
#include "formats/picture/svg/legend.h"
#include "formats/picture/svg/shown_parts.h"
#include "formats/picture/svg/text.h"
#include "pliant/geometry/linear_triangle.h"

namespace pliant {
namespace {

constexpr int max_pieces = 8;
constexpr double color_tolerance = 0.01;  // how far a field's colour may be off in an element, as a part of the range

/// Appends what is shown of an element as closed path data.
void write_shown(const Drawing& drawing, TriangleId t, SvgPath& path) {
  ElementPieces(drawing, t)
      .for_shown(ElementPieces::whole, [&](const ElementPieces::Corners&, const std::vector<Point>& net) {
        write_outline(drawing.mesh.degree, net, path);
      });
}

/// The layer of elements while it is being written.
class ElementLayer {
 public:
  ElementLayer(const Drawing& drawing, std::string& out)
      : drawing_(drawing), path_(drawing.path(out)), in_outline_(drawing.path(outline_)) {}
  void faces();
  void flat(TriangleId t);
  void shaded(TriangleId t);

 private:
  void shaded_piece(const std::vector<Point>& net, const std::array<double, 3>& places, double middle);
  int pieces(TriangleId t) const;
  double place(double value) const { return drawing_.range.place(value); }

  const Drawing& drawing_;
  SvgPath path_;
  std::string outline_;
  SvgPath in_outline_;
  int gradients_ = 0;
};

void ElementLayer::flat(TriangleId t) {
  outline_.clear();
  write_shown(drawing_, t, in_outline_);
  if (outline_.empty()) return;
  const std::string color = hex(drawing_.color_at(t, {1, 0, 0}));
  path_.text("<path fill=\"").text(color).text("\" stroke=\"").text(color).text("\" d=\"").text(outline_);
  path_.text("\"/>\n");
}

int ElementLayer::pieces(TriangleId t) const {
  if (drawing_.options.subdivide > 0) return drawing_.options.subdivide;
  // Halved: the difference of two doubles may overflow.
  const double allowed = color_tolerance * 2 * (drawing_.range.high / 2 - drawing_.range.low / 2);
  const double departure = drawing_.values.departure(t);
  // The departure from a linear function falls with the square of the piece's size.
  int n = 1;
  while (n < max_pieces && departure > allowed * n * n) n *= 2;
  return n;
}

/// Draws a piece in the colours of the linear function of the plane that has the given places in the range at its
/// corners. On a straight edge both neighbours have the same colours.
void ElementLayer::shaded_piece(const std::vector<Point>& net, const std::array<double, 3>& places, double middle) {
  const double area = triangle_area(net[0], net[1], net[2]);
  const double longest = std::max({distance(net[0], net[1]), distance(net[1], net[2]), distance(net[2], net[0])});
  const Vector slope = (perpendicular(net[2] - net[1]) * places[0] + perpendicular(net[0] - net[2]) * places[1] +
                        perpendicular(net[1] - net[0]) * places[2]) /
                       (2 * area);
  std::string paint;
  if (std::abs(area) > 1e-4 * longest * longest && squared_length(slope) > 0 && length(slope) * longest > 2e-3) {
    const Vector rise = slope / squared_length(slope);
    const std::string id = std::string("g").append(std::to_string(++gradients_));
    const Point low = net[0] - rise * places[0], high = net[0] + rise * (1 - places[0]);
    path_.text("<linearGradient id=\"").text(id).text("\" xlink:href=\"#map\" x1=\"").number(low.x);
    path_.text("\" y1=\"").number(-low.y).text("\" x2=\"").number(high.x).text("\" y2=\"").number(-high.y);
    path_.text("\"/>");
    paint.append("url(#").append(id).append(")");
  } else {
    paint = hex(drawing_.map.at(middle));
  }
  path_.text("<path fill=\"").text(paint).text("\" stroke=\"").text(paint).text("\" d=\"");
  write_outline(drawing_.mesh.degree, net, path_);
  path_.text("\"/>\n");
}

void ElementLayer::shaded(TriangleId t) {
  const int n = pieces(t);
  const ElementValues& values = drawing_.values;
  ElementPieces element(drawing_, t);
  const ElementPieces::Use shade = [&](const ElementPieces::Corners& corners, const std::vector<Point>& net) {
    const auto& [a, b, c] = corners;
    const Barycentric middle{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
    shaded_piece(net, {place(values.at(t, a)), place(values.at(t, b)), place(values.at(t, c))},
                 place(values.at(t, middle)));
  };
  const auto node = [n](int i, int j) { return Barycentric{double(n - i - j) / n, double(i) / n, double(j) / n}; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      element.for_shown({node(i, j), node(i + 1, j), node(i, j + 1)}, shade);
      if (i + j < n - 1) element.for_shown({node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}, shade);
    }
}

void ElementLayer::faces() {
  const MeshData& mesh = drawing_.mesh;
  std::map<FaceId, std::vector<TriangleId>> by_face;
  for (TriangleId t = 0; t < drawing_.triangles(); ++t)
    by_face[mesh.triangle_faces[static_cast<std::size_t>(t)]].push_back(t);
  for (const auto& [face, members] : by_face) {
    outline_.clear();
    for (const TriangleId t : members) write_shown(drawing_, t, in_outline_);
    if (outline_.empty()) continue;
    const std::string color = hex(face_color(drawing_.theme, face));
    path_.text("<path fill=\"").text(color).text("\" stroke=\"").text(color).text("\" d=\"").text(outline_);
    path_.text("\"><title>").text(escape_xml(mesh.boundary.faces[static_cast<std::size_t>(face)].name));
    path_.text("</title></path>\n");
  }
}

}  // namespace

void draw_elements(const Drawing& drawing, std::string& out) {
  const ColorBy::Kind kind = drawing.options.color.kind;
  if (kind == ColorBy::Kind::nothing) return;
  // A hairline of the element's own colour closes the seams that smoothing leaves between neighbours.
  out += "<g class=\"elements\" stroke-linejoin=\"round\"";
  drawing.path(out).text(" stroke-width=\"" + short_number((drawing.values.is_field() ? 1 : 0.5) * drawing.pixel));
  out += "\">\n";
  ElementLayer layer(drawing, out);
  if (kind == ColorBy::Kind::face) {
    layer.faces();
  } else if (drawing.values.is_field()) {
    out += "<defs><linearGradient id=\"map\" gradientUnits=\"userSpaceOnUse\">";
    gradient_stops(drawing.map, out);
    out += "</linearGradient></defs>\n";
    for (TriangleId t = 0; t < drawing.triangles(); ++t) layer.shaded(t);
  } else {
    for (TriangleId t = 0; t < drawing.triangles(); ++t) layer.flat(t);
  }
  out += "</g>\n";
}

void draw_marks(const Drawing& drawing, std::string& out) {
  SvgPath path = drawing.path(out);
  const auto mark = [&](const std::vector<TriangleId>& triangles, const Rgb& color, std::string_view word) {
    if (triangles.empty()) return;
    path.text("<path class=\"")
        .text(word)
        .text("\" fill=\"")
        .text(hex(color))
        .text("\" fill-opacity=\"0.6\" stroke=\"");
    path.text(hex(color)).text("\"").text(drawing.stroke_width(1.6)).text(" stroke-linejoin=\"round\" d=\"");
    for (const TriangleId t : triangles) write_shown(drawing, t, path);
    path.text("\"><title>").text(std::to_string(triangles.size())).text(" ").text(word).text("</title></path>\n");
  };
  mark(drawing.bad.degenerate, degenerate_color, "degenerate");
  mark(drawing.bad.invalid, invalid_color, "invalid");
}

}  // namespace pliant
