// formats/picture/svg_legend.h: the column beside a picture that says what its colours mean.
#pragma once
#include <string>

#include "formats/picture/coloring.h"

namespace pliant {

inline constexpr double min_legend_height = 200;  // in pixels

struct Legend {
  const MeshData& mesh;
  ColorBy::Kind kind;
  const Colormap& map;
  const std::string& title;
  ValueRange range;
  std::size_t invalid, degenerate;
};

/// Width of the column in pixels. Names of faces need more than a colour bar.
double legend_width(const MeshData& mesh, ColorBy::Kind kind);
/// Appends the column, its left edge at `left`, for a picture `height` pixels high.
void write_legend(const Legend& legend, double left, double height, std::string& out);
/// Appends the stops of a gradient with the map's colours.
void gradient_stops(const Colormap& map, std::string& out);

}  // namespace pliant
