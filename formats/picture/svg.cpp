// formats/picture/svg.cpp: a still picture of a mesh as SVG (formats/svg.md).
#include "formats/picture/svg.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "formats/picture/field_polynomial.h"
#include "formats/picture/svg/arrows.h"
#include "formats/picture/svg/drawing.h"
#include "formats/picture/svg/frame.h"
#include "formats/picture/svg/isolines.h"
#include "formats/picture/svg/legend.h"
#include "formats/picture/svg/placement.h"
#include "formats/picture/svg/text.h"
#include "pliant/quality/metrics.h"

namespace pliant {
namespace {

/// The title of the colours with its unit.
std::string legend_title(const ElementValues& values, const SvgOptions& options) {
  std::string unit = options.color_unit;
  if (const Metric* metric = find_metric(options.color.name);
      unit.empty() && !options.unit.empty() && options.color.kind == ColorBy::Kind::metric && metric != nullptr) {
    if (metric->unit == Metric::Unit::length) unit = options.unit;
    if (metric->unit == Metric::Unit::area) unit = options.unit + "\xC2\xB2";
  }
  return unit.empty() ? values.title() : values.title() + " (" + unit + ")";
}

void write_head(const MeshData& mesh, const SvgOptions& options, const Theme& theme, const InvalidElements& bad,
                double width, double height, std::string& out) {
  const auto count = [](std::size_t n, const char* noun) {
    return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
  };
  out += "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"" +
         short_number(options.width) + "\" height=\"" + short_number(std::ceil(height * options.scale)) +
         "\" viewBox=\"0 0 " + short_number(width) + " " + short_number(height) + "\">\n<title>";
  const std::string time = "Mesh at time " + short_number(mesh.time);
  out += options.title.empty() ? time : escape_xml(options.title);
  out += "</title>\n<desc>";
  if (!options.title.empty()) out += time + ", ";
  out += count(mesh.triangle_faces.size(), "element") + " of degree " + std::to_string(mesh.degree) + ", " +
         std::to_string(bad.invalid.size()) + " invalid, " + std::to_string(bad.degenerate.size()) +
         " degenerate</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"" +
         (theme.paper == Rgb{1, 1, 1} ? "#fff" : hex(theme.paper)) + "\"/>\n";
}

/// The values of the colours. Metrics are those of the document, in its own unit.
ElementValues color_values(const MeshData& mesh, const MeshData& document, const SvgOptions& options) {
  try {
    return ElementValues(options.color.kind == ColorBy::Kind::metric ? document : mesh, options.color);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("--color: ") + error.what());
  }
}

}  // namespace

std::vector<std::string> write_svg(const MeshData& document, const SvgOptions& wanted, std::string& out) {
  const PlacedDocument placed(document, wanted);
  const MeshData& mesh = placed.mesh();
  const SvgOptions& options = placed.options();
  const Placement& placement = placed.placement();
  const Box& box = placed.box();
  const Theme* theme = find_theme(options.theme);
  if (theme == nullptr) throw std::invalid_argument("--theme: there is none of the name '" + options.theme + "'");
  const Colormap& map = options.map != nullptr ? *options.map : *find_colormap(theme->map);
  const ElementValues values = color_values(mesh, document, options);
  const InvalidElements bad = find_invalid(document);
  const ValueRange range = options.range.value_or(exact_range(mesh, values, bad.invalid));
  const Legend legend{mesh,
                      options.color.kind,
                      *theme,
                      map,
                      legend_title(values, options),
                      range,
                      bad.invalid.size(),
                      bad.degenerate.size()};
  const bool wants_legend = options.legend && options.color.kind != ColorBy::Kind::nothing;
  Frame frame(options, *theme, box, placement,
              wants_legend ? [&legend](double height) { return legend_width(legend, height); }
                           : std::function<double(double)>());
  constexpr double most_pixels = 1e7;  // more than any mesh makes high without a box
  if (!(frame.drawn_height() * options.scale <= most_pixels))
    throw std::invalid_argument("--box: the picture would be " + short_number(frame.drawn_height() * options.scale) +
                                " pixels high, more than 1e7");
  const MeshEdges edges = find_edges(mesh);
  const double size = std::min(bounding_box(mesh).size(), box.size());
  const Drawing drawing{mesh, options, *theme, map, values, range, bad, edges, box, placement, size, frame.pixel()};

  std::vector<Key> keys;
  std::string layers;
  if (options.scale_bar) keys.push_back(frame.scale_bar());
  draw_circles(drawing, layers);
  draw_elements(drawing, layers);
  draw_inner_edges(drawing, layers);
  draw_marks(drawing, layers);
  for (std::size_t k = 0; k < options.isolines.size(); ++k)
    keys.push_back(draw_isolines(drawing, options.isolines[k], k, layers));
  draw_curves(drawing, layers);
  draw_logical_mesh(drawing, layers);
  draw_control_net(drawing, layers);
  if (options.arrows) keys.push_back(draw_arrows(drawing, *options.arrows, layers));

  const double height = frame.place_keys(keys);
  write_head(mesh, options, *theme, bad, frame.width(), height, out);
  SvgPath text(out, box.size(), 0);
  frame.write_title(out);
  text.text("<svg");
  if (frame.left() > 0 || frame.top() > 0)
    text.text(" x=\"" + short_number(frame.left()) + "\" y=\"" + short_number(frame.top()) + "\"");
  text.text(" width=\"" + short_number(frame.drawn_width()) + "\" height=\"" + short_number(frame.drawn_height()));
  text.text("\" viewBox=\"").number(box.low.x).text(" ").number(-box.high.y).text(" ");
  text.number(box.high.x - box.low.x).text(" ").number(box.high.y - box.low.y).text("\"");
  if (placement.unit != 1) text.text(" data-unit=\"" + exact_number(placement.unit) + "\"");
  if (const Point& origin = placement.origin; origin != Point{})
    text.text(" data-origin=\"" + exact_number(origin.x) + " " + exact_number(origin.y) + "\"");
  text.text(">\n").text(layers).text("</svg>\n");
  frame.write_axes(out);
  frame.write_keys(out);
  if (frame.has_legend()) write_legend(legend, frame.legend_left(), frame.top(), frame.legend_height(), out);
  text.text("</svg>\n");
  return frame.left_out();
}

}  // namespace pliant
