// formats/picture/svg.cpp: a still picture of a mesh as SVG (formats/svg.md).
#include "formats/picture/svg.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "formats/picture/mesh_edges.h"
#include "formats/picture/svg_legend.h"
#include "formats/picture/svg_path.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/mesh/check_mesh.h"

namespace pliant {
namespace {

constexpr double margin = 0.03;  // around the control points, as a part of the larger side
constexpr int max_pieces = 8;
constexpr double color_tolerance = 0.01;  // how far a field's colour may be off in an element, as a part of the range
constexpr std::string_view ink = "#14232e";

Box shown_box(const MeshData& mesh, const SvgOptions& options) {
  if (options.box) return *options.box;
  Box box = bounding_box(mesh);
  for (const Circle& circle : options.circles) {
    const Vector reach{circle.radius, circle.radius};
    box.extend(circle.center - reach);
    box.extend(circle.center + reach);
  }
  if (box.size() == 0) box = {box.low - Vector{0.5, 0.5}, box.high + Vector{0.5, 0.5}};
  const double larger = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  // Even a picture of a straight line needs some height and width.
  const auto grow = [larger](double side) { return margin * larger + std::max(0.0, 0.05 * larger - side) / 2; };
  const Vector by{grow(box.high.x - box.low.x), grow(box.high.y - box.low.y)};
  return {box.low - by, box.high + by};
}

/// The picture of one mesh while it is being written.
class Drawing {
 public:
  Drawing(const MeshData& mesh, const SvgOptions& options, const ElementValues& values, const ValueRange& range,
          double pixel, std::string& out)
      : mesh_(mesh),
        options_(options),
        values_(values),
        range_(range),
        layout_(NetLayout::of(mesh.degree)),
        edges_(find_edges(mesh)),
        bad_(find_invalid(mesh)),
        pixel_(pixel),
        out_(out),
        path_(out, bounding_box(mesh).size(), options.tolerance * bounding_box(mesh).size(), options.resolution) {}

  void elements();
  void marks();
  void inner_edges();
  void curves();
  void control_net();
  void circles();

 private:
  TriangleId triangles() const { return static_cast<TriangleId>(mesh_.triangle_faces.size()); }
  SvgPath& width(double pixels) { return path_.text(" stroke-width=\"" + short_number(pixels * pixel_) + "\""); }
  void outline(const std::vector<Point>& net);
  void element_paths(const std::vector<TriangleId>& triangles);
  void flat_element(TriangleId t);
  void shaded_element(TriangleId t);
  void shaded_piece(const std::vector<Point>& net, const std::array<double, 3>& values, double middle);
  int pieces(TriangleId t) const;
  double fine_width() const;

  const MeshData& mesh_;
  const SvgOptions& options_;
  const ElementValues& values_;
  ValueRange range_;
  const NetLayout& layout_;
  MeshEdges edges_;
  InvalidElements bad_;
  double pixel_;  // size of a pixel in mesh units
  std::string& out_;
  SvgPath path_;
  int gradients_ = 0;
};

/// Writes the closed boundary of an element as path data.
void Drawing::outline(const std::vector<Point>& net) {
  path_.move_to(net[0]);
  std::vector<Point> polygon(static_cast<std::size_t>(mesh_.degree) + 1);
  for (int e = 0; e < 3; ++e) {
    for (int k = 0; k <= mesh_.degree; ++k)
      polygon[static_cast<std::size_t>(k)] = net[static_cast<std::size_t>(layout_.edge_index(e, k))];
    path_.curve_to(polygon);
  }
  path_.text("Z");
}

void Drawing::element_paths(const std::vector<TriangleId>& triangles) {
  for (const TriangleId t : triangles) outline(element_net(mesh_, t));
}

void Drawing::flat_element(TriangleId t) {
  const double value = values_.of_element(t);
  const std::string color = hex(std::isfinite(value) ? options_.map->at(range_.place(value)) : missing_color);
  path_.text("<path fill=\"").text(color).text("\" stroke=\"").text(color).text("\" d=\"");
  outline(element_net(mesh_, t));
  path_.text("\"/>\n");
}

int Drawing::pieces(TriangleId t) const {
  if (options_.subdivide > 0) return options_.subdivide;
  const double allowed = color_tolerance * (range_.high - range_.low);
  const double departure = values_.departure(t);
  // The departure from a linear function falls with the square of the piece's size.
  int n = 1;
  while (n < max_pieces && departure > allowed * n * n) n *= 2;
  return n;
}

/// Draws a piece in the colours of the linear function of the plane that has the given values at its corners. On a
/// straight edge both neighbours have the same colours.
void Drawing::shaded_piece(const std::vector<Point>& net, const std::array<double, 3>& values, double middle) {
  const double area = triangle_area(net[0], net[1], net[2]);
  const double longest = std::max({distance(net[0], net[1]), distance(net[1], net[2]), distance(net[2], net[0])});
  const Vector slope = (perpendicular(net[2] - net[1]) * values[0] + perpendicular(net[0] - net[2]) * values[1] +
                        perpendicular(net[1] - net[0]) * values[2]) /
                       (2 * area);
  const double span = range_.high - range_.low;
  std::string paint;
  if (std::abs(area) > 1e-4 * longest * longest && squared_length(slope) > 0 && length(slope) * longest > 2e-3 * span) {
    const Vector rise = slope / squared_length(slope);
    const std::string id = std::string("g").append(std::to_string(++gradients_));
    const Point low = net[0] + rise * (range_.low - values[0]), high = net[0] + rise * (range_.high - values[0]);
    path_.text("<linearGradient id=\"").text(id).text("\" xlink:href=\"#map\" x1=\"").number(low.x);
    path_.text("\" y1=\"").number(-low.y).text("\" x2=\"").number(high.x).text("\" y2=\"").number(-high.y);
    path_.text("\"/>");
    paint.append("url(#").append(id).append(")");
  } else {
    paint = hex(options_.map->at(range_.place(middle)));
  }
  path_.text("<path fill=\"").text(paint).text("\" stroke=\"").text(paint).text("\" d=\"");
  outline(net);
  path_.text("\"/>\n");
}

void Drawing::shaded_element(TriangleId t) {
  const std::vector<Point> net = element_net(mesh_, t);
  std::vector<double> rows, piece(2 * net.size());
  for (const Point& p : net) rows.insert(rows.end(), {p.x, p.y});
  const int n = pieces(t);
  const auto draw = [&](const Barycentric& a, const Barycentric& b, const Barycentric& c) {
    sub_net(mesh_.degree, 2, rows, a, b, c, piece);
    std::vector<Point> part;
    for (std::size_t i = 0; i < piece.size(); i += 2) part.push_back({piece[i], piece[i + 1]});
    const Barycentric middle{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
    shaded_piece(part, {values_.at(t, a), values_.at(t, b), values_.at(t, c)}, values_.at(t, middle));
  };
  const auto node = [n](int i, int j) { return Barycentric{double(n - i - j) / n, double(i) / n, double(j) / n}; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      draw(node(i, j), node(i + 1, j), node(i, j + 1));
      if (i + j < n - 1) draw(node(i + 1, j), node(i + 1, j + 1), node(i, j + 1));
    }
}

void Drawing::elements() {
  if (options_.color.kind == ColorBy::Kind::nothing) return;
  path_.text("<g class=\"elements\" stroke-linejoin=\"round\"");
  // A hairline of the element's own colour closes the seams that smoothing leaves between neighbours.
  width(values_.is_field() ? 1 : 0.5).text(">\n");
  if (options_.color.kind == ColorBy::Kind::face) {
    std::map<FaceId, std::vector<TriangleId>> by_face;
    for (TriangleId t = 0; t < triangles(); ++t)
      by_face[mesh_.triangle_faces[static_cast<std::size_t>(t)]].push_back(t);
    for (const auto& [face, members] : by_face) {
      const std::string color = hex(face_color(face));
      path_.text("<path fill=\"").text(color).text("\" stroke=\"").text(color).text("\" d=\"");
      element_paths(members);
      path_.text("\"><title>").text(escape_xml(mesh_.boundary.faces[static_cast<std::size_t>(face)].name));
      path_.text("</title></path>\n");
    }
  } else if (values_.is_field()) {
    path_.text("<defs><linearGradient id=\"map\" gradientUnits=\"userSpaceOnUse\">");
    gradient_stops(*options_.map, out_);
    path_.text("</linearGradient></defs>\n");
    for (TriangleId t = 0; t < triangles(); ++t) shaded_element(t);
  } else {
    for (TriangleId t = 0; t < triangles(); ++t) flat_element(t);
  }
  path_.text("</g>\n");
}

void Drawing::marks() {
  const auto mark = [this](const std::vector<TriangleId>& triangles, const Rgb& color, std::string_view word) {
    if (triangles.empty()) return;
    path_.text("<path class=\"")
        .text(word)
        .text("\" fill=\"")
        .text(hex(color))
        .text("\" fill-opacity=\"0.6\" stroke=\"");
    path_.text(hex(color)).text("\"");
    width(1.6).text(" stroke-linejoin=\"round\" d=\"");
    element_paths(triangles);
    path_.text("\"><title>").text(std::to_string(triangles.size())).text(" ").text(word).text("</title></path>\n");
  };
  mark(bad_.degenerate, degenerate_color, "degenerate");
  mark(bad_.invalid, invalid_color, "invalid");
}

/// The width of lines between elements: thinner where elements are small, or a fine mesh would be nothing but lines.
double Drawing::fine_width() const {
  double sum = 0;
  for (const MeshEdge& edge : edges_.edges)
    sum += distance(mesh_.points[static_cast<std::size_t>(edge.points.front())],
                    mesh_.points[static_cast<std::size_t>(edge.points.back())]);
  return std::clamp(0.035 * sum / double(edges_.edges.size()) / pixel_, 0.15, 1.0);
}

void Drawing::inner_edges() {
  if (!options_.edges) return;
  path_.text("<path class=\"edges\" fill=\"none\" stroke=\"").text(ink).text("\" stroke-opacity=\"0.6\"");
  width(fine_width()).text(" stroke-linecap=\"round\" d=\"");
  for (const MeshEdge& edge : edges_.edges)
    if (edge.constrained == none)
      path_.move_to(mesh_.points[static_cast<std::size_t>(edge.points.front())])
          .curve_to(positions(mesh_, edge.points));
  path_.text("\"/>\n");
}

void Drawing::curves() {
  std::map<CurveId, std::map<int, const ConstrainedEdge*>> by_curve;
  for (const ConstrainedEdge& edge : mesh_.constrained_edges) by_curve[edge.curve][edge.span] = &edge;
  path_.text("<g class=\"curves\" fill=\"none\" stroke=\"").text(ink).text("\" stroke-linejoin=\"round\"");
  width(2.2).text(">\n");
  for (const auto& [curve, spans] : by_curve) {
    path_.text("<path d=\"");
    PointId at = none, first = none;
    for (const auto& [span, edge] : spans) {
      if (edge->points.front() != at) {
        first = edge->points.front();
        path_.move_to(mesh_.points[static_cast<std::size_t>(first)]);
      }
      path_.curve_to(positions(mesh_, edge->points));
      at = edge->points.back();
      if (at == first) path_.text("Z");
    }
    path_.text("\"><title>").text(escape_xml(mesh_.boundary.curves[static_cast<std::size_t>(curve)].name));
    path_.text("</title></path>\n");
  }
  path_.text("</g>\n");
}

void Drawing::control_net() {
  if (!options_.control_net) return;
  std::set<std::pair<PointId, PointId>> legs;
  std::set<PointId> points;
  const auto size = static_cast<std::size_t>(layout_.size());
  for (std::size_t t = 0; t < mesh_.triangle_faces.size(); ++t)
    for (int n = 0; n < layout_.size(); ++n) {
      const auto [i, j, k] = layout_.exponents(n);
      const auto point = [&](int a, int b) {
        return mesh_.triangles[t * size + static_cast<std::size_t>(layout_.index(a, b))];
      };
      const PointId p = point(i, j);
      points.insert(p);
      const auto leg = [&](PointId q) { legs.insert(std::minmax(p, q)); };
      if (i > 0) leg(point(i - 1, j + 1)), leg(point(i - 1, j));
      if (j > 0) leg(point(i, j - 1));
    }
  path_.text("<g class=\"control-net\" fill=\"none\" stroke=\"#d6336c\" stroke-linecap=\"round\">\n<path");
  width(0.5 * fine_width() + 0.2).text(" stroke-opacity=\"0.8\" d=\"");
  for (const auto& [p, q] : legs)
    path_.move_to(mesh_.points[static_cast<std::size_t>(p)]).text("L").point(mesh_.points[static_cast<std::size_t>(q)]);
  // A line without length but with round ends is drawn as a dot.
  path_.text("\"/>\n<path");
  width(2.5 * fine_width() + 1).text(" d=\"");
  for (const PointId p : points) path_.move_to(mesh_.points[static_cast<std::size_t>(p)]).text("h0");
  path_.text("\"/>\n</g>\n");
}

void Drawing::circles() {
  for (const Circle& circle : options_.circles) {
    path_.text("<circle fill=\"").text(hex(obstacle_color)).text("\" stroke=\"#8d959d\"");
    width(1.2).text(" cx=\"").number(circle.center.x).text("\" cy=\"").number(-circle.center.y);
    path_.text("\" r=\"").number(circle.radius).text("\"/>\n");
  }
}

}  // namespace

void write_svg(const MeshData& mesh, const SvgOptions& options, std::string& out) {
  const ElementValues values(mesh, options.color);
  const InvalidElements bad = find_invalid(mesh);
  const ValueRange range = options.range.value_or(values.range(bad.invalid));
  const bool has_legend = options.legend && options.color.kind != ColorBy::Kind::nothing;
  const Box box = shown_box(mesh, options);
  const double side = has_legend ? legend_width(mesh, options.color.kind) : 0;
  const double drawn = std::max(1.0, options.width - side);
  const double pixel = (box.high.x - box.low.x) / drawn;
  const double high = (box.high.y - box.low.y) / pixel;
  const double height = std::ceil(has_legend ? std::max(high, min_legend_height) : high);

  SvgPath text(out, box.size(), 0);
  text.text("<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"");
  text.text(short_number(options.width)).text("\" height=\"").text(short_number(height)).text("\" viewBox=\"0 0 ");
  text.text(short_number(options.width)).text(" ").text(short_number(height)).text("\">\n");
  const auto count = [](std::size_t n, const char* noun) {
    return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
  };
  text.text("<title>Mesh at time " + short_number(mesh.time) + "</title>\n<desc>");
  text.text(count(mesh.triangle_faces.size(), "element") + " of degree " + std::to_string(mesh.degree) + ", " +
            std::to_string(bad.invalid.size()) + " invalid, " + std::to_string(bad.degenerate.size()) +
            " degenerate</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
  text.text("<svg width=\"" + short_number(drawn) + "\" height=\"" + short_number(high) + "\" viewBox=\"");
  text.number(box.low.x).text(" ").number(-box.high.y).text(" ").number(box.high.x - box.low.x).text(" ");
  text.number(box.high.y - box.low.y).text("\">\n");
  Drawing drawing(mesh, options, values, range, pixel, out);
  drawing.circles();
  drawing.elements();
  drawing.inner_edges();
  drawing.marks();
  drawing.curves();
  drawing.control_net();
  text.text("</svg>\n");
  if (has_legend) {
    Legend legend{mesh,  options.color.kind, *options.map,         values.title(),
                  range, bad.invalid.size(), bad.degenerate.size()};
    write_legend(legend, options.width - side, height, out);
  }
  text.text("</svg>\n");
}

}  // namespace pliant
