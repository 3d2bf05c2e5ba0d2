// formats/picture/svg/drawing.cpp: what the layers of a picture share, and the plain ones: circles, nets.
#include "formats/picture/svg/drawing.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "formats/picture/svg/shown_parts.h"
#include "formats/picture/svg/text.h"

namespace pliant {

Rgb Drawing::color_at(TriangleId t, const Barycentric& xi) const {
  switch (options.color.kind) {
    case ColorBy::Kind::nothing:
      return theme.paper;
    case ColorBy::Kind::face:
      return face_color(theme, mesh.triangle_faces[static_cast<std::size_t>(t)]);
    default: {
      const double value = values.at(t, xi);
      return std::isfinite(value) ? map.at(range.place(value)) : missing_color;
    }
  }
}

SvgPath Drawing::path(std::string& out) const {
  return SvgPath(out, size, options.tolerance * size, options.resolution);
}

std::string Drawing::stroke_width(double pixels) const {
  return " stroke-width=\"" + short_number(pixels * theme.line * pixel) + "\"";
}

double Drawing::fine_width() const {
  if (edges.edges.empty()) return 1;
  double sum = 0;
  for (const MeshEdge& edge : edges.edges) sum += distance(at(edge.points.front()), at(edge.points.back()));
  return std::clamp(0.035 * sum / double(edges.edges.size()) / pixel, 0.15, 1.0);
}

void write_outline(int degree, const std::vector<Point>& net, SvgPath& path) {
  const NetLayout& layout = NetLayout::of(degree);
  path.move_to(net[0]);
  std::vector<Point> polygon(static_cast<std::size_t>(degree) + 1);
  for (int e = 0; e < 3; ++e) {
    for (int k = 0; k <= degree; ++k)
      polygon[static_cast<std::size_t>(k)] = net[static_cast<std::size_t>(layout.edge_index(e, k))];
    path.curve_to(polygon);
  }
  path.text("Z");
}

void draw_circles(const Drawing& drawing, std::string& out) {
  SvgPath path = drawing.path(out);
  for (const Circle& circle : drawing.options.circles) {
    path.text("<circle fill=\"").text(hex(drawing.theme.obstacle)).text("\" stroke=\"#8d959d\"");
    path.text(drawing.stroke_width(1.2)).text(" cx=\"").number(circle.center.x);
    path.text("\" cy=\"").number(-circle.center.y).text("\" r=\"").number(circle.radius).text("\"/>\n");
  }
}

void draw_control_net(const Drawing& drawing, std::string& out) {
  if (!drawing.options.control_net) return;
  const MeshData& mesh = drawing.mesh;
  const NetLayout& layout = NetLayout::of(mesh.degree);
  std::set<std::pair<PointId, PointId>> legs;
  std::set<PointId> points;
  const auto size = static_cast<std::size_t>(layout.size());
  for (std::size_t t = 0; t < mesh.triangle_faces.size(); ++t)
    for (int n = 0; n < layout.size(); ++n) {
      const auto [i, j, k] = layout.exponents(n);
      const auto point = [&](int a, int b) {
        return mesh.triangles[t * size + static_cast<std::size_t>(layout.index(a, b))];
      };
      const PointId p = point(i, j);
      points.insert(p);
      const auto leg = [&](PointId q) { legs.insert(std::minmax(p, q)); };
      if (i > 0) leg(point(i - 1, j + 1)), leg(point(i - 1, j));
      if (j > 0) leg(point(i, j - 1));
    }
  const double fine = drawing.fine_width();
  SvgPath path = drawing.path(out);
  path.text("<g class=\"control-net\" fill=\"none\" stroke=\"#d6336c\" stroke-linecap=\"round\">\n<path");
  path.text(drawing.stroke_width(0.5 * fine + 0.2)).text(" stroke-opacity=\"0.8\" d=\"");
  const auto draw = [&path](const std::vector<Point>& line) {
    path.move_to(line.front()).text("L").point(line.back());
  };
  for (const auto& [p, q] : legs) for_shown_parts(drawing, {drawing.at(p), drawing.at(q)}, draw);
  // A line without length but with round ends is drawn as a dot.
  path.text("\"/>\n<path").text(drawing.stroke_width(2.5 * fine + 1)).text(" d=\"");
  for (const PointId p : points)
    if (is_drawn_whole(drawing, {&drawing.at(p), 1})) path.move_to(drawing.at(p)).text("h0");
  path.text("\"/>\n</g>\n");
}

void draw_logical_mesh(const Drawing& drawing, std::string& out) {
  if (!drawing.options.logical_mesh) return;
  SvgPath path = drawing.path(out);
  const double fine = drawing.fine_width();
  const std::string dash = short_number(4 * fine * drawing.pixel);
  path.text(
      "<path class=\"logical-mesh\" fill=\"none\" stroke=\"#1c7ed6\" stroke-linecap=\"round\" stroke-dasharray=\"");
  path.text(dash).text(" ").text(dash).text("\"").text(drawing.stroke_width(fine + 0.2)).text(" d=\"");
  for (const MeshEdge& edge : drawing.edges.edges)
    for_shown_parts(
        drawing, {drawing.at(edge.points.front()), drawing.at(edge.points.back())},
        [&path](const std::vector<Point>& line) { path.move_to(line.front()).text("L").point(line.back()); });
  path.text("\"/>\n");
}

}  // namespace pliant
