// tools/options/picture_options.h: the options that export-svg and export-gltf share.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "formats/picture/coloring.h"

namespace CLI {
class App;
}

namespace pliant {

/// What is drawn and in which colours, as the command line says it.
class PictureOptions {
 public:
  /// Adds --color, --colormap, --range, --subdivide, --no-edges, --circle.
  void add(CLI::App& app);
  /// Reads the texts; call it before any input is read.   Throws UsageError
  void check();
  /// True if the command line names a colour map.
  bool names_map() const { return map_given_; }

  ColorBy color;
  const Colormap* map = nullptr;
  std::optional<ValueRange> range;
  int subdivide = 0;
  bool no_edges = false;
  std::vector<Circle> circles;

 private:
  bool map_given_ = false;
  std::string color_ = "shape", map_ = "viridis", range_;
  std::vector<std::string> circles_;
};

/// Finite numbers between separators.   Throws UsageError, which begins with the option's name
std::vector<double> parse_numbers(const std::string& option, const std::string& text, char separator, std::size_t count,
                                  const char* form);

}  // namespace pliant
