// formats/picture/svg_legend.cpp: the column beside a picture that says what its colours mean.
#include "formats/picture/svg_legend.h"

#include <algorithm>
#include <cmath>

#include "formats/picture/svg_path.h"

namespace pliant {
namespace {

constexpr double bar_left = 18, bar_width = 14, row = 22;
constexpr double letter = 6.6;  // width in pixels allowed for a letter of 12 pixels: generous on average

void text_at(std::string& out, double x, double y, std::string_view attributes, std::string_view text) {
  out += "<text x=\"" + short_number(x) + "\" y=\"" + short_number(y) + "\"";
  out.append(attributes).append(">").append(escape_xml(text)).append("</text>\n");
}

/// Writes time and counts at the top. Returns the height that they take.
double heading(const Legend& legend, std::string& out) {
  double y = 24;
  text_at(out, bar_left, y, " font-weight=\"600\" fill=\"#14232e\"", "t = " + short_number(legend.mesh.time));
  const auto warn = [&](std::size_t count, const Rgb& color, const char* word) {
    if (count == 0) return;
    y += 18;
    text_at(out, bar_left, y, " font-weight=\"600\" fill=\"" + hex(color) + "\"", std::to_string(count) + " " + word);
  };
  warn(legend.invalid, invalid_color, "invalid");
  warn(legend.degenerate, degenerate_color, "degenerate");
  return y;
}

void face_rows(const Legend& legend, double top, std::string& out) {
  double y = top + 16;
  for (std::size_t f = 0; f < legend.mesh.boundary.faces.size(); ++f, y += row) {
    out += "<rect x=\"" + short_number(bar_left) + "\" y=\"" + short_number(y) +
           "\" width=\"14\" height=\"14\" rx=\"3\" fill=\"" + hex(face_color(static_cast<FaceId>(f))) + "\"/>\n";
    text_at(out, bar_left + 22, y + 11, "", legend.mesh.boundary.faces[f].name);
  }
}

void color_bar(const Legend& legend, double top, double height, std::string& out) {
  if (legend.range.is_empty()) return;
  const double bar_top = top + 22, bar_height = std::min(320.0, height - bar_top - 22);
  out += "<defs><linearGradient id=\"bar\" x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\">";
  gradient_stops(legend.map, out);
  out += "</linearGradient></defs>\n<rect x=\"" + short_number(bar_left) + "\" y=\"" + short_number(bar_top) +
         "\" width=\"" + short_number(bar_width) + "\" height=\"" + short_number(bar_height) +
         "\" rx=\"2\" fill=\"url(#bar)\"/>\n";
  const double right = bar_left + bar_width;
  std::size_t longest = 0;
  for (const double value : ticks(legend.range, std::max(2, static_cast<int>(bar_height / 55)))) {
    const double y = bar_top + bar_height * (1 - legend.range.place(value));
    const std::string label = short_number(value);
    longest = std::max(longest, label.size());
    out += "<path stroke=\"#5c6770\" d=\"M" + short_number(right) + " " + short_number(y) + "h4\"/>\n";
    text_at(out, right + 8, y + 4, "", label);
  }
  const std::string x = short_number(right + 8 + letter * double(longest) + 16);
  const std::string y = short_number(bar_top + bar_height / 2);
  out += "<text transform=\"translate(" + x + " " + y + ") rotate(-90)\" text-anchor=\"middle\">" +
         escape_xml(legend.title) + "</text>\n";
}

}  // namespace

double legend_width(const MeshData& mesh, ColorBy::Kind kind) {
  if (kind != ColorBy::Kind::face) return 122;
  std::size_t longest = 10;
  for (const Face& face : mesh.boundary.faces) longest = std::max(longest, face.name.size());
  return bar_left + 30 + letter * double(std::min<std::size_t>(longest, 30));
}

void write_legend(const Legend& legend, double left, double height, std::string& out) {
  out += "<g class=\"legend\" transform=\"translate(" + short_number(left) +
         " 0)\" font-family=\"system-ui, 'Segoe UI', Roboto, 'DejaVu Sans', Helvetica, Arial, sans-serif\" "
         "font-size=\"12\" fill=\"#3d4952\">\n";
  const double top = heading(legend, out);
  if (legend.kind == ColorBy::Kind::face)
    face_rows(legend, top, out);
  else
    color_bar(legend, top, height, out);
  out += "</g>\n";
}

void gradient_stops(const Colormap& map, std::string& out) {
  for (std::size_t i = 0; i < map.stops.size(); ++i)
    out += "<stop offset=\"" + short_number(double(i) / double(map.stops.size() - 1)) + "\" stop-color=\"" +
           hex(map.stops[i]) + "\"/>";
}

}  // namespace pliant
