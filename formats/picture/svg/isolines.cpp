// formats/picture/svg/isolines.cpp: the layer of a field's isolines.
#include "formats/picture/svg/isolines.h"

#include <cmath>
#include <stdexcept>

#include "formats/picture/isolines/isolines.h"
#include "formats/picture/mesh_edges.h"
#include "formats/picture/svg/shown_parts.h"
#include "formats/picture/svg/text.h"

namespace pliant {
namespace {

constexpr double width = 1.5, halo_width = 3.2;

std::vector<double> values_of(const IsolineRequest& request, const ValueRange& range) {
  if (!request.values.empty()) return request.values;
  std::vector<double> values;
  // A field that is constant up to rounding has no values between its ends.
  const double spread = range.high / 2 - range.low / 2;
  if (range.is_empty() || !(spread > 1e-12 * std::max(std::abs(range.low), std::abs(range.high)))) return values;
  for (int k = 1; k <= request.count; ++k)
    values.push_back(std::lerp(range.low, range.high, double(k) / (request.count + 1)));
  return values;
}

std::string key_text(const std::string& name, const IsolineRequest& request, const std::vector<double>& values) {
  if (values.empty()) return name + ": constant, no isolines";
  std::string text = name + " = " + short_number(values.front());
  if (request.values.empty() && values.size() > 2)
    return text + " to " + short_number(values.back()) + ", steps of " + short_number(values[1] - values[0]);
  for (std::size_t k = 1; k < values.size(); ++k) text += ", " + short_number(values[k]);
  return text;
}

void write_lines(const Drawing& drawing, const IsolineSet& set, SvgPath& path) {
  for (const Isoline& line : set.lines) {
    bool goes_on = false, is_whole = true;
    for (const std::vector<Point>& curve : line.curves) {
      if (is_drawn_whole(drawing, curve)) {
        if (!goes_on) path.move_to(curve.front());
        path.curve_to(curve);
        goes_on = true;
      } else {
        for_shown_parts(drawing, curve,
                        [&path](const std::vector<Point>& part) { path.move_to(part.front()).curve_to(part); });
        goes_on = is_whole = false;
      }
    }
    if (line.closed && is_whole) path.text("Z");
  }
}

}  // namespace

Key draw_isolines(const Drawing& drawing, const IsolineRequest& request, std::size_t number, std::string& out) {
  std::optional<ElementValues> field;
  try {
    field.emplace(drawing.mesh, ColorBy{ColorBy::Kind::field, request.field});
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("--isolines: ") + error.what());
  }
  const bool colored = drawing.options.color.kind != ColorBy::Kind::nothing;
  const bool same = drawing.values.is_field() && drawing.values.title() == field->title();
  const ValueRange range = same && drawing.options.range ? drawing.range
                           : request.values.empty()      ? exact_range(drawing.mesh, *field, drawing.bad.invalid)
                                                         : ValueRange();
  const std::vector<double> values = values_of(request, range);
  const std::string name = field->title().substr(field->title().find(' ') + 1);  // without the word "field"

  FieldPolynomial polynomial(drawing.mesh, *field);
  const double tolerance = drawing.options.tolerance * bounding_box(drawing.mesh).size();
  std::vector<bool> shown;
  for (TriangleId t = 0; t < static_cast<TriangleId>(drawing.mesh.triangle_faces.size()); ++t)
    shown.push_back(is_shown(drawing, element_net(drawing.mesh, t)));
  const auto in_element = [&shown](TriangleId t) { return shown[static_cast<std::size_t>(t)]; };
  out += "<g class=\"isolines\" fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double value = polynomial.from_field(values[k]);
    if (!std::isfinite(value)) continue;
    const IsolineSet set = trace_isoline(drawing.mesh, drawing.edges, polynomial, value, tolerance, in_element);
    if (set.lines.empty()) continue;
    const std::string id = "isoline" + std::to_string(number) + "-" + std::to_string(k);
    out += "<defs><path id=\"" + id + "\" class=\"isoline\" data-value=\"" + exact_number(values[k]) + "\" d=\"";
    SvgPath path = drawing.path(out);
    write_lines(drawing, set, path);
    out += "\"/></defs>\n";
    const auto use = [&](const Rgb& ink, double pixels, const std::string& attributes, const std::string& content) {
      out += "<use xlink:href=\"#" + id + "\" stroke=\"" + hex(ink) + "\"" + drawing.stroke_width(pixels) + attributes +
             ">" + content + "</use>\n";
    };
    Rgb ink = drawing.theme.ink;
    if (same) {
      // The colour along the line is known: one of the inks is seen on it.
      const Rgb beneath = drawing.map.at(drawing.range.place(values[k]));
      if (contrast(drawing.theme.other_ink, beneath) > contrast(ink, beneath)) ink = drawing.theme.other_ink;
    } else if (colored) {
      use(drawing.theme.other_ink, halo_width, " class=\"halo\" stroke-opacity=\"0.7\"", "");
    }
    use(ink, width, "", "<title>" + escape_xml(name) + " = " + short_number(values[k]) + "</title>");
  }
  out += "</g>\n";
  return {Key::Sign::curve, 22, key_text(name, request, values)};
}

}  // namespace pliant
