// formats/report/report_csv.cpp: writes the columns of the table of elements.
#include "formats/report/report_csv.h"

#include <array>
#include <cmath>
#include <string_view>

#include "formats/document/write_json.h"
#include "formats/picture/mesh_edges.h"
#include "pliant/geometry/control_net.h"

namespace pliant {
namespace {

/// A cell as RFC 4180 has it: in quotes where a comma, a quote or a line break is in it.
void append_cell(std::string& out, std::string_view text) {
  if (text.find_first_of("\",\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

/// A comma and the number; an empty cell where there is none.
void append_value(std::string& out, double value) {
  out += ',';
  if (std::isfinite(value)) append_number(out, value);
}

std::string_view word(Validity validity) {
  if (validity == Validity::valid) return "valid";
  return validity == Validity::degenerate ? "degenerate" : "invalid";
}

Point barycentre(const MeshData& mesh, TriangleId t) {
  std::vector<double> net;
  for (const Point& p : element_net(mesh, t)) net.insert(net.end(), {p.x, p.y});
  std::array<double, 2> place{};
  constexpr double third = 1.0 / 3;
  evaluate_net(mesh.degree, 2, net, {third, third, third}, place);
  return {place[0], place[1]};
}

}  // namespace

void write_csv_header(const ElementFigures& elements, std::string& out) {
  out += "frame,triangle,face,validity,x,y";
  for (const ElementColumn& column : elements.columns) append_cell(out += ',', column.name);
  out += '\n';
}

void write_csv_elements(const MeshData& mesh, const ElementFigures& elements, std::int64_t frame, std::string& out) {
  for (std::size_t k = 0; k < elements.triangles.size(); ++k) {
    const TriangleId t = elements.triangles[k];
    append_integer(out, frame);
    out += ',';
    append_integer(out, t);
    out += ',';
    const FaceId face = mesh.triangle_faces[static_cast<std::size_t>(t)];
    append_cell(out, mesh.boundary.faces[static_cast<std::size_t>(face)].name);
    out += ',';
    out += word(elements.validity[k]);
    const Point at = barycentre(mesh, t);
    append_value(out, at.x);
    append_value(out, at.y);
    for (const ElementColumn& column : elements.columns) append_value(out, column.values[k]);
    out += '\n';
  }
}

}  // namespace pliant
