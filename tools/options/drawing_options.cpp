// tools/options/drawing_options.cpp: the options of export-svg for what is drawn beside the elements.
#include "options/drawing_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

#include "formats/picture/svg/theme.h"
#include "options/numbers.h"
#include "run/exit_status.h"
#include "run/output_file.h"

namespace pliant {
namespace {

constexpr int most_isolines = 1000, most_arrows = 500;

int count_within(const std::string& option, const std::string& text, int most) {
  const std::optional<long> count = whole_number(text);
  if (!count || *count < 1 || *count > most)
    throw UsageError(option + ": '" + text + "' is not a whole number from 1 to " + std::to_string(most));
  return static_cast<int>(*count);
}

/// FIELD, FIELD=N or FIELD=V,V…: one number with a point, an exponent, or a comma behind it is a value.
IsolineRequest parse_isolines(const std::string& text) {
  IsolineRequest request;
  const std::size_t equals = text.rfind('=');
  request.field = text.substr(0, equals);
  if (request.field.empty()) throw UsageError("--isolines '" + text + "': FIELD, FIELD=N or FIELD=V1,V2,... is wanted");
  if (equals == std::string::npos) return request;
  const std::string rest = text.substr(equals + 1);
  if (whole_number(rest)) {
    try {
      request.count = count_within("--isolines " + text, rest, most_isolines);
    } catch (const UsageError& error) {
      throw UsageError(std::string(error.what()) + "; the value " + rest + " alone is written " + request.field + "=" +
                       rest + ",");
    }
    return request;
  }
  for (std::size_t from = 0; from < rest.size();) {
    const std::size_t end = std::min(rest.find(',', from), rest.size());
    request.values.push_back(parse_number("--isolines " + text, rest.substr(from, end - from)));
    from = end + 1;
  }
  if (request.values.empty()) throw UsageError("--isolines '" + text + "': there is no number behind '='");
  if (request.values.size() > most_isolines)
    throw UsageError("--isolines " + request.field + ": at most " + std::to_string(most_isolines) + " values");
  return request;
}

ArrowRequest parse_arrows(const std::string& text) {
  ArrowRequest request{text};
  const std::size_t colon = text.rfind(':');
  // A name may hold a colon: only a number behind it is a count.
  if (colon != std::string::npos && whole_number(text.substr(colon + 1))) {
    request.field = text.substr(0, colon);
    request.count = count_within("--arrows " + text, text.substr(colon + 1), most_arrows);
  }
  if (request.field.empty()) throw UsageError("--arrows '" + text + "': FIELD or FIELD:N is wanted");
  return request;
}

}  // namespace

void DrawingOptions::add(CLI::App& app) {
  app.add_option("--format", format_name_, "svg, png or pdf; by default what FILE's name ends with, or else svg")
      ->type_name("FORMAT");
  app.add_option("--theme", theme_, "light, dark, or print: white paper, thin black lines, greys")
      ->type_name("NAME")
      ->capture_default_str();
  app.add_option("--title", title_, "a line of text above the picture")->type_name("TEXT");
  app.add_flag("--axes", axes_, "draw axes with ticks at round numbers");
  app.add_flag("--scale-bar", scale_bar_, "draw a bar of a round length below the picture");
  app.add_option("--unit", unit_, "of lengths, for axes, scale bar and colours by length or area, such as mm")
      ->type_name("TEXT");
  app.add_option("--color-unit", color_unit_, "of what colours the elements")->type_name("TEXT");
  app.add_option("--scale", scale_, "makes texts and lines larger or smaller, 1 by default")->type_name("FACTOR");
  app.add_option("--isolines", isolines_,
                 "draw curves on which a field has one value: at N values between its least and its greatest one (10), "
                 "or at the values listed (one alone is written with a comma: FIELD=1,); repeatable")
      ->type_name("FIELD[.COMPONENT][=N|=V,V...]")
      ->allow_extra_args(false);
  app.add_option("--arrows", arrows_,
                 "draw a field of two components as arrows, N of them along the longer side (24 by default)")
      ->type_name("FIELD[:N]");
  app.add_option("--layer", layers_, "draw control-net or logical-mesh (straight edges) too; repeatable")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_flag("--control-net", control_net_, "the same as --layer control-net");
}

void DrawingOptions::check(const std::string& output, SvgOptions& svg) {
  std::string name = format_name_;
  for (const std::string_view other :
       {".jpg", ".jpeg", ".gif", ".webp", ".tif", ".tiff", ".bmp", ".eps", ".ps", ".svgz"})
    if (name.empty() && has_ending(output, other))
      throw UsageError("-o " + output + ": pictures are svg, png or pdf, not " + std::string(other.substr(1)) +
                       "; --format writes one under any name");
  if (name.empty()) name = has_ending(output, ".png") ? "png" : has_ending(output, ".pdf") ? "pdf" : "svg";
  if (name == "png")
    format_ = Format::png;
  else if (name == "pdf")
    format_ = Format::pdf;
  else if (name != "svg")
    throw UsageError("--format: '" + name + "' is none of svg, png, pdf");
#ifndef PLIANT_RSVG
  if (format_ != Format::svg)
    throw UsageError("--format " + name + ": this export-svg was built without librsvg (-DPLIANT_RSVG=OFF): svg only");
#endif
  if (find_theme(theme_) == nullptr) throw UsageError("--theme: '" + theme_ + "' is none of light, dark, print");
  svg.theme = theme_;
  svg.title = title_;
  svg.unit = unit_;
  svg.color_unit = color_unit_;
  svg.axes = axes_;
  svg.scale_bar = scale_bar_;
  svg.control_net = control_net_;
  if (!scale_.empty()) {
    svg.scale = parse_positive("--scale", scale_);
    if (svg.scale < 0.1 || svg.scale > 100) throw UsageError("--scale " + scale_ + ": from 0.1 to 100");
  }
  for (const std::string& layer : layers_) {
    if (layer == "control-net")
      svg.control_net = true;
    else if (layer == "logical-mesh")
      svg.logical_mesh = true;
    else
      throw UsageError("--layer: '" + layer + "' is none of control-net, logical-mesh");
  }
  for (const std::string& text : isolines_) svg.isolines.push_back(parse_isolines(text));
  if (!arrows_.empty()) svg.arrows = parse_arrows(arrows_);
}

}  // namespace pliant
