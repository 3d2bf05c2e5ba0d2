// tools/options/picture_options.cpp: the options that export-svg and export-gltf share.
#include "options/picture_options.h"

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "options/numbers.h"
#include "options/obstacles.h"
#include "run/exit_status.h"

namespace pliant {

std::vector<double> parse_numbers(const std::string& option, const std::string& text, char separator, std::size_t count,
                                  const char* form) {
  std::vector<double> numbers;
  std::size_t from = 0;
  for (std::size_t end = 0; end != std::string::npos; from = end + 1) {
    end = text.find(separator, from);
    numbers.push_back(parse_number(option, text.substr(from, end - from)));
    if (end == std::string::npos) break;
  }
  if (numbers.size() != count) throw UsageError(option + " " + text + ": " + form + " is wanted");
  return numbers;
}

void PictureOptions::add(CLI::App& app) {
  app.add_option("--color", color_,
                 "what colours the elements: none, face, field:NAME[.COMPONENT] (counted from 0; without it the "
                 "length), or a metric of qualityreport")
      ->type_name("none|face|field:FIELD[.COMPONENT]|METRIC")
      ->capture_default_str();
  std::string names;
  for (const Colormap& each : colormaps()) names.append(names.empty() ? "" : "|").append(each.name);
  app.add_option_function<std::string>(
         "--colormap", [this](const std::string& name) { map_ = name, map_given_ = true; },
         "the colours, from the least value to the greatest")
      ->type_name(names)
      ->default_str(map_);
  app.add_option("--range", range_, "values of the first and the last colour; by default those of the input")
      ->type_name("LOW:HIGH");
  app.add_option("--subdivide", subdivide, "cut every edge into N pieces; 0: as many as it takes")
      ->type_name("N")
      ->check(CLI::Range(0, 64))
      ->capture_default_str();
  app.add_flag("--no-edges", no_edges, "draw constrained edges only");
  app.add_option("--circle", circles_, "draw a disk, an obstacle say, under the mesh; repeatable")
      ->type_name("X,Y,R")
      ->allow_extra_args(false);
}

void PictureOptions::check() {
  try {
    color = parse_color_by(color_);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--color: ") + error.what());
  }
  map = find_colormap(map_);
  if (map == nullptr) throw UsageError("--colormap: there is none of the name '" + map_ + "'; see --help");
  if (!range_.empty()) {
    const std::vector<double> ends = parse_numbers("--range", range_, ':', 2, "LOW:HIGH");
    if (ends[0] > ends[1]) throw UsageError("--range " + range_ + ": LOW is above HIGH");
    range = {ends[0], ends[1]};
  }
  circles = parse_circles(circles_);
}

}  // namespace pliant
