// formats/report/report_html.cpp: the report as one page that draws the mesh, needs nothing else, and fetches nothing.
#include "formats/report/report_html.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "formats/document/document_value.h"
#include "formats/document/history.h"
#include "formats/document/write_json.h"
#include "formats/picture/base64.h"
#include "formats/picture/coloring.h"
#include "formats/picture/mesh_edges.h"
#include "formats/picture/svg/text.h"
#include "formats/report/report_json.h"
#include "formats/report/report_page.h"
#include "pliant/quality/metrics.h"

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

Json hex_of(std::span<const Rgb> colors) {
  Json list = Json::array();
  for (const Rgb& color : colors) list.push_back(hex(color));
  return list;
}

/// What the page calls the metrics: the sign of their unit is all of it that has room.
Json metric_words() {
  Json words = Json::object();
  for (const Metric& metric : all_metrics())
    words[std::string(metric.name)] = {
        {"label", metric.label}, {"text", metric.text}, {"unit", metric.unit == Metric::Unit::degrees ? "°" : ""}};
  return words;
}

/// The same colours as in pictures (SVG, glTF).
Json settings(const HtmlReport::Options& options) {
  constexpr int face_colors = 10;
  std::vector<Rgb> faces;
  for (FaceId f = 0; f < face_colors; ++f) faces.push_back(face_color(f));
  Json circles = Json::array(), outlines = Json::array();
  for (const Circle& circle : options.circles)
    circles.push_back(Json::array({circle.center.x, circle.center.y, circle.radius}));
  for (const std::vector<Point>& outline : options.outlines) {
    Json numbers = Json::array();
    for (const Point& p : outline) {
      numbers.push_back(p.x);
      numbers.push_back(p.y);
    }
    outlines.push_back(std::move(numbers));
  }
  return {{"title", options.title},
          {"circles", std::move(circles)},
          {"outlines", std::move(outlines)},
          {"worst", options.worst},
          {"metrics", metric_words()},
          {"viridis", hex_of(find_colormap("viridis")->stops)},
          {"faces", hex_of(faces)},
          {"invalid", hex(invalid_color)},
          {"degenerate", hex(degenerate_color)},
          {"missing", hex(missing_color)}};
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

/// Left, low, right, high of the elements' control points; null where there are none.
Json box_of(const MeshData& mesh, const ElementFigures& elements) {
  ValueRange x, y;
  for (const TriangleId t : elements.triangles) {
    for (const PointId p : element_points(mesh, t)) {
      x.extend(mesh.points[static_cast<std::size_t>(p)].x);
      y.extend(mesh.points[static_cast<std::size_t>(p)].y);
    }
  }
  if (x.is_empty()) return nullptr;
  return Json::array({x.low, y.low, x.high, y.high});
}

/// Where the mesh lies over itself.
Json overlaps_of(const QualityReport& report) {
  Json list = Json::array();
  for (const OverlapPlace& overlap : report.overlap_places) {
    Json triangles = Json::array({overlap.first});
    if (overlap.second != none) triangles.push_back(overlap.second);
    Json entry{{"triangles", std::move(triangles)}};
    if (std::isfinite(overlap.place.x) && std::isfinite(overlap.place.y))
      entry["at"] = Json::array({overlap.place.x, overlap.place.y});
    list.push_back(std::move(entry));
  }
  return list;
}

/// For each entry of the elements' nets the row of a field by face.
std::vector<std::int32_t> rows_of(const MeshData& mesh, const ElementFigures& elements, const Field& field) {
  std::vector<std::int32_t> rows;
  for (const TriangleId t : elements.triangles)
    for (const PointId p : element_points(mesh, t)) {
      const std::array<std::int32_t, 2> place{p, mesh.triangle_faces[static_cast<std::size_t>(t)]};
      const auto found = std::lower_bound(field.places.begin(), field.places.end(), place);
      // A place that is missing is a fault; the row after the last has no numbers.
      const bool is_there = found != field.places.end() && *found == place;
      rows.push_back(static_cast<std::int32_t>((is_there ? found : field.places.end()) - field.places.begin()));
    }
  return rows;
}

/// The ranges of a field's control values, which bound it: of each component, and of the length of several.
void add_field_ranges(const MeshData& mesh, const ElementFigures& elements, const Field& field, Json& ranges) {
  const auto width = static_cast<std::size_t>(field.components);
  std::vector<ValueRange> parts(width + 1);
  const auto add = [&](std::int32_t row) {
    double length = 0;
    for (std::size_t c = 0; c < width; ++c) {
      const std::size_t at = static_cast<std::size_t>(row) * width + c;
      const double value = at < field.values.size() ? field.values[at] : std::nan("");
      parts[c].extend(value);
      length = std::hypot(length, value);
    }
    parts[width].extend(length);
  };
  if (field.by_face)
    for (const std::int32_t row : rows_of(mesh, elements, field)) add(row);
  else
    for (const TriangleId t : elements.triangles)
      for (const PointId p : element_points(mesh, t)) add(p);
  const auto put = [&ranges](const std::string& name, const ValueRange& range) {
    ranges[name] = range.is_empty() ? Json() : Json::array({range.low, range.high});
  };
  const std::string name = "field:" + field.name;
  put(name, parts[width == 1 ? 0 : width]);
  for (std::size_t c = 0; c < width && width > 1; ++c) put(name + '.' + std::to_string(c), parts[c]);
}

Json ranges_of(const MeshData& mesh, const ElementFigures& elements) {
  Json ranges = Json::object();
  for (const ElementColumn& column : elements.columns) {
    const ValueRange range = range_of(elements, column);
    ranges[column.name] = range.is_empty() ? Json() : Json::array({range.low, range.high});
  }
  for (const Field& field : mesh.fields) add_field_ranges(mesh, elements, field, ranges);
  return ranges;
}

/// The tools that made the mesh, as its member `history` names them: their options as words of a command line.
Json history_words(const MeshData& mesh) {
  Json list = Json::array();
  for (const HistoryEntry& entry : history_of(mesh.extra)) {
    std::string words;
    for (const std::string& option : entry.options) words += (words.empty() ? "" : " ") + option;
    list.push_back({{"tool", entry.tool}, {"version", entry.version}, {"options", words}});
  }
  return list;
}

/// Small, and of all frames at once in the page's memory: the report, the box, and the ranges of the colours.
std::string frame_summary(const MeshData& mesh, const QualityReport& report, const ElementFigures& elements,
                          const std::string& source) {
  std::string text, whole_report;
  JsonWriter json(text);
  json.begin_object();
  write_members(json, {{"source", source},
                       {"box", box_of(mesh, elements)},
                       {"overlaps", overlaps_of(report)},
                       {"duplicate_points", report.duplicate_points},
                       {"unused_points", report.unused_points},
                       {"ranges", ranges_of(mesh, elements)}});
  if (const Json history = history_words(mesh); !history.empty()) write_members(json, {{"history", history}});
  write_report(report, {}, whole_report);
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
    const std::span<const PointId> net = element_points(mesh, elements.triangles[k]);
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
  json.end_array().name("fields").begin_array();
  for (const Field& field : mesh.fields) {
    json.begin_object().name("name").value(field.name).name("components").value(field.components);
    write_array(json, "values", field.values);
    if (field.by_face) write_array(json, "rows", rows_of(mesh, elements, field));
    json.end_object();
  }
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
  std::string text;
  append_json(text, settings(options));
  append_script("id=\"settings\"", text, out);
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
