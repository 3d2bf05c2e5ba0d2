// formats/report/report_html.cpp: the report as one page that draws the mesh, needs nothing else, and fetches nothing.
#include "formats/report/report_html.h"

#include <cmath>
#include <string_view>

#include "formats/document/write_json.h"
#include "formats/picture/base64.h"
#include "formats/picture/coloring.h"
#include "formats/picture/svg_path.h"
#include "formats/report/report_json.h"
#include "formats/report/report_page.h"

namespace pliant {
namespace {

/// JSON inside of a script element: no "<", so that no text of the document can end the element.
void append_script(std::string_view attributes, std::string_view json, std::string& out) {
  out.append("<script type=\"application/json\" ").append(attributes).append(">");
  for (const char c : json) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  out += "</script>\n";
}

void write_colors(JsonWriter& json, std::string_view name, std::span<const Rgb> colors) {
  json.name(name).begin_array();
  for (const Rgb& color : colors) json.value(hex(color));
  json.end_array();
}

/// The same colours as in pictures (SVG, glTF).
std::string settings(const HtmlReport::Options& options) {
  constexpr int face_colors = 10;
  std::vector<Rgb> faces;
  for (FaceId f = 0; f < face_colors; ++f) faces.push_back(face_color(f));
  std::string text;
  JsonWriter json(text);
  json.begin_object();
  json.name("title").value(options.title);
  json.name("worst").value(options.worst);
  write_colors(json, "viridis", find_colormap("viridis")->stops);
  write_colors(json, "faces", faces);
  json.name("invalid").value(hex(invalid_color));
  json.name("degenerate").value(hex(degenerate_color));
  json.name("missing").value(hex(missing_color));
  json.end_object();
  return text;
}

/// What colours span: the values of the elements that are not invalid, whose numbers would drown the others.
ValueRange range_of(const ElementFigures& elements, const ElementColumn& column) {
  ValueRange range;
  for (std::size_t k = 0; k < column.values.size(); ++k)
    if (elements.validity[k] != Validity::invalid) range.extend(column.values[k]);
  return range;
}

template <class Number>
void write_array(JsonWriter& json, std::string_view name, const std::vector<Number>& numbers) {
  std::string text = "\"";
  append_base64(numbers, text);
  json.name(name).raw(text += '"');
}

std::span<const PointId> net_of(const MeshData& mesh, TriangleId t) {
  const std::size_t size = mesh.triangles.size() / mesh.triangle_faces.size();
  return std::span(mesh.triangles).subspan(static_cast<std::size_t>(t) * size, size);
}

/// Left, low, right, high of the elements' control points; null where there are none.
void write_box(JsonWriter& json, const MeshData& mesh, const ElementFigures& elements) {
  ValueRange x, y;
  for (const TriangleId t : elements.triangles) {
    for (const PointId p : net_of(mesh, t)) {
      x.extend(mesh.points[static_cast<std::size_t>(p)].x);
      y.extend(mesh.points[static_cast<std::size_t>(p)].y);
    }
  }
  json.name("box");
  if (x.is_empty())
    json.null();
  else
    json.begin_array().value(x.low).value(y.low).value(x.high).value(y.high).end_array();
}

/// What the page shows beside the report's own members: where the mesh lies over itself.
void write_overlaps(JsonWriter& json, const QualityReport& report) {
  json.name("overlaps").begin_array();
  for (const OverlapPlace& overlap : report.overlap_places) {
    json.begin_object().name("triangles").begin_array().value(overlap.first);
    if (overlap.second != none) json.value(overlap.second);
    json.end_array();
    if (std::isfinite(overlap.place.x) && std::isfinite(overlap.place.y))
      json.name("at").begin_array().value(overlap.place.x).value(overlap.place.y).end_array();
    json.end_object();
  }
  json.end_array();
  json.name("duplicate_points").value(report.duplicate_points);
  json.name("unused_points").value(report.unused_points);
}

/// Small, and of all frames at once in the page's memory: the report, the box, and the ranges of the colours.
std::string frame_summary(const MeshData& mesh, const QualityReport& report, const ElementFigures& elements,
                          const std::string& source) {
  std::string text, whole_report;
  JsonWriter json(text);
  json.begin_object();
  json.name("source").value(source);
  write_box(json, mesh, elements);
  write_overlaps(json, report);
  json.name("ranges").begin_object();
  for (const ElementColumn& column : elements.columns) {
    const ValueRange range = range_of(elements, column);
    json.name(column.name);
    if (range.is_empty())
      json.null();
    else
      json.begin_array().value(range.low).value(range.high).end_array();
  }
  json.end_object();
  write_report(report, whole_report);
  whole_report.pop_back();
  json.name("report").raw(whole_report);
  json.end_object();
  return text;
}

/// Large, decoded when the frame is shown: the control points and nets of the elements, and their figures.
std::string frame_mesh(const MeshData& mesh, const ElementFigures& elements) {
  std::vector<double> points;
  points.reserve(2 * mesh.points.size());
  for (const Point& p : mesh.points) points.insert(points.end(), {p.x, p.y});
  std::vector<std::int32_t> nets, faces, ends;
  std::vector<unsigned char> validity;
  for (std::size_t k = 0; k < elements.triangles.size(); ++k) {
    const auto t = static_cast<std::size_t>(elements.triangles[k]);
    const std::span<const PointId> net = net_of(mesh, elements.triangles[k]);
    nets.insert(nets.end(), net.begin(), net.end());
    faces.push_back(mesh.triangle_faces[t]);
    validity.push_back(static_cast<unsigned char>(elements.validity[k]));
  }
  for (const ConstrainedEdge& edge : mesh.constrained_edges)
    ends.insert(ends.end(), {edge.points.front(), edge.points.back(), edge.curve});
  std::string text;
  JsonWriter json(text);
  json.begin_object();
  json.name("degree").value(mesh.degree);
  write_array(json, "points", points);
  write_array(json, "triangles", elements.triangles);
  write_array(json, "nets", nets);
  write_array(json, "faces", faces);
  write_array(json, "validity", validity);
  write_array(json, "constrained", ends);
  json.name("face_names").begin_array();
  for (const Face& face : mesh.boundary.faces) json.value(face.name);
  json.end_array().name("curve_names").begin_array();
  for (const Curve& curve : mesh.boundary.curves) json.value(curve.name);
  json.end_array().name("columns").begin_array();
  for (const ElementColumn& column : elements.columns) {
    json.begin_object().name("name").value(column.name).name("worst_is_least").value(column.worst_is_least);
    write_array(json, "values", column.values);
    json.end_object();
  }
  json.end_array().end_object();
  return text;
}

}  // namespace

void HtmlReport::begin(const Options& options, std::string& out) {
  constexpr std::string_view mark = "{{title}}";
  std::string head;
  for (const std::string_view piece : report_page_head()) head += piece;
  out += head.replace(head.find(mark), mark.size(), escape_xml(options.title));
  append_script("id=\"settings\"", settings(options), out);
}

void HtmlReport::frame(const MeshData& mesh, const QualityReport& report, const ElementFigures& elements,
                       const std::string& source, std::string& out) {
  append_script("class=\"frame\"", frame_summary(mesh, report, elements, source), out);
  append_script("class=\"mesh\"", frame_mesh(mesh, elements), out);
}

void HtmlReport::end(std::string& out) {
  for (const std::string_view piece : report_page_tail()) out += piece;
}

}  // namespace pliant
