// formats/picture/svg/legend.cpp: the column beside a picture that says what its colours mean.
#include "formats/picture/svg/legend.h"

#include <algorithm>
#include <cmath>

#include "formats/picture/svg/text.h"

namespace pliant {
namespace {

constexpr double bar_left = 18, bar_width = 14, row = 22, legend_font = 12, line = 14;
constexpr double least_width = 122, most_name = 220;

/// The lines above the colours: the time, and how many elements are bad.
struct Heading {
  std::string text;
  std::string color;
};
std::vector<Heading> heading(const Legend& legend) {
  std::vector<Heading> lines{{"t = " + short_number(legend.mesh.time), hex(legend.theme.ink)}};
  if (legend.invalid > 0) lines.push_back({std::to_string(legend.invalid) + " invalid", hex(invalid_color)});
  if (legend.degenerate > 0)
    lines.push_back({std::to_string(legend.degenerate) + " degenerate", hex(degenerate_color)});
  return lines;
}
double heading_height(const Legend& legend) { return 24 + 18 * (double(heading(legend).size()) - 1); }

/// The colour bar: where it stands, and the numbers beside it, the first and last of them its ends.
struct Bar {
  double top, height;
  std::vector<double> values;
  std::vector<std::string> labels;
  std::vector<std::string> title;
  double labels_width = 0;
  double title_left() const { return bar_left + bar_width + 8 + labels_width + 16; }
};

Bar bar_of(const Legend& legend, double height) {
  Bar bar{heading_height(legend) + 22, 0, {}, {}, {}};
  bar.height = std::clamp(height - bar.top - 22, 60.0, 320.0);
  const ValueRange& range = legend.range;
  const auto y = [&](double value) { return bar.height * range.place(value); };
  std::vector<double> inner = ticks(range, std::max(2, static_cast<int>(bar.height / 55)));
  std::erase_if(inner, [&](double v) { return y(v) < line || y(v) > bar.height - line; });
  bar.values = inner;
  bar.labels = tick_labels(inner);
  if (range.low < range.high) {
    const auto text = [&range](double value) {
      const bool alike = short_number(range.low) == short_number(range.high);
      return alike ? exact_number(value) : short_number(value);
    };
    bar.values.insert(bar.values.begin(), range.low), bar.values.push_back(range.high);
    bar.labels.insert(bar.labels.begin(), text(range.low)), bar.labels.push_back(text(range.high));
  } else {
    bar.values = {range.low}, bar.labels = {short_number(range.low)};
  }
  for (const std::string& label : bar.labels)
    bar.labels_width = std::max(bar.labels_width, text_width(label, legend_font));
  bar.title = wrapped(legend.title, bar.height, legend_font, false, 3);
  return bar;
}

std::size_t rows_within(const Legend& legend, double height) {
  const auto rows = static_cast<std::size_t>(std::max(1.0, (height - heading_height(legend) - 16) / row));
  const std::size_t faces = legend.mesh.boundary.faces.size();
  return faces <= rows ? faces : rows - 1;
}

void face_rows(const Legend& legend, double height, std::string& out) {
  double y = heading_height(legend) + 16;
  const std::size_t faces = legend.mesh.boundary.faces.size(), shown = rows_within(legend, height);
  for (std::size_t f = 0; f < shown; ++f, y += row) {
    out += "<rect x=\"" + short_number(bar_left) + "\" y=\"" + short_number(y) +
           "\" width=\"14\" height=\"14\" rx=\"3\" fill=\"" + hex(face_color(legend.theme, static_cast<FaceId>(f))) +
           "\"/>\n";
    write_text(out, bar_left + 22, y + 11, "", shortened(legend.mesh.boundary.faces[f].name, most_name, legend_font));
  }
  if (shown < faces) write_text(out, bar_left, y + 11, "", "and " + std::to_string(faces - shown) + " more");
}

void color_bar(const Legend& legend, double height, std::string& out) {
  if (legend.range.is_empty()) return;
  const Bar bar = bar_of(legend, height);
  out += "<defs><linearGradient id=\"bar\" x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\">";
  gradient_stops(legend.map, out);
  out += "</linearGradient></defs>\n<rect x=\"" + short_number(bar_left) + "\" y=\"" + short_number(bar.top) +
         "\" width=\"" + short_number(bar_width) + "\" height=\"" + short_number(bar.height) +
         "\" rx=\"2\" fill=\"url(#bar)\"/>\n";
  const double right = bar_left + bar_width;
  for (std::size_t k = 0; k < bar.values.size(); ++k) {
    const double y = bar.top + bar.height * (1 - legend.range.place(bar.values[k]));
    out += "<path stroke=\"" + hex(legend.theme.faint) + "\" d=\"M" + short_number(right) + " " + short_number(y) +
           "h4\"/>\n";
    write_text(out, right + 8, y + 4, "", bar.labels[k]);
  }
  const std::string y = short_number(bar.top + bar.height / 2);
  for (std::size_t k = 0; k < bar.title.size(); ++k)
    out += "<text transform=\"translate(" + short_number(bar.title_left() + line * double(k)) + " " + y +
           ") rotate(-90)\" text-anchor=\"middle\">" + escape_xml(bar.title[k]) + "</text>\n";
}

}  // namespace

double legend_width(const Legend& legend, double height) {
  double width = 0;
  for (const Heading& each : heading(legend))
    width = std::max(width, bar_left + text_width(each.text, legend_font, true));
  if (legend.kind == ColorBy::Kind::face) {
    const std::vector<Face>& faces = legend.mesh.boundary.faces;
    for (std::size_t f = 0; f < rows_within(legend, height); ++f)
      width = std::max(width, bar_left + 22 + std::min(most_name, text_width(faces[f].name, legend_font)));
    return std::max(width + 8, 96.0);
  }
  if (!legend.range.is_empty()) {
    const Bar bar = bar_of(legend, height);
    width = std::max(width, bar.title_left() + line * (double(bar.title.size()) - 1));
  }
  return std::max(width + 8, least_width);
}

void write_legend(const Legend& legend, double left, double top, double height, std::string& out) {
  out += "<g class=\"legend\"";
  if (legend.kind != ColorBy::Kind::face && !legend.range.is_empty())
    out += " data-min=\"" + exact_number(legend.range.low) + "\" data-max=\"" + exact_number(legend.range.high) + "\"";
  out += " transform=\"translate(" + short_number(left) + " " + short_number(top) + ")\" font-family=\"";
  out.append(font_family).append("\" font-size=\"12\" fill=\"").append(hex(legend.theme.text)).append("\">\n");
  double y = 24;
  for (const Heading& each : heading(legend)) {
    write_text(out, bar_left, y, " font-weight=\"600\" fill=\"" + each.color + "\"", each.text);
    y += 18;
  }
  if (legend.kind == ColorBy::Kind::face)
    face_rows(legend, height, out);
  else
    color_bar(legend, height, out);
  out += "</g>\n";
}

void gradient_stops(const Colormap& map, std::string& out) {
  for (std::size_t i = 0; i < map.stops.size(); ++i)
    out += "<stop offset=\"" + short_number(double(i) / double(map.stops.size() - 1)) + "\" stop-color=\"" +
           hex(map.stops[i]) + "\"/>";
}

}  // namespace pliant
