// tools/options/drawing_options.h: the options of export-svg for what is drawn beside the elements.
#pragma once
#include <string>
#include <vector>

#include "formats/picture/svg.h"

namespace CLI {
class App;
}

namespace pliant {

/// Title, axes, theme, layers, isolines, arrows and the format of the picture, as the command line says them.
class DrawingOptions {
 public:
  enum class Format { svg, png, pdf };

  void add(CLI::App& app);
  /// Reads the texts into `svg`; call it before any input is read. The format is by default the one that the output's
  /// name ends with.   Throws UsageError
  void check(const std::string& output, SvgOptions& svg);
  Format format() const { return format_; }

 private:
  std::string theme_ = "light", title_, unit_, color_unit_, arrows_, format_name_, scale_;
  std::vector<std::string> isolines_, layers_;
  bool axes_ = false, scale_bar_ = false, control_net_ = false;
  Format format_ = Format::svg;
};

}  // namespace pliant
