// formats/picture/svg/legend.h: the column beside a picture that says what its colours mean.
#pragma once
#include <string>

#include "formats/picture/coloring.h"
#include "formats/picture/svg/theme.h"

namespace pliant {

inline constexpr double min_legend_height = 200;  // in pixels

struct Legend {
  const MeshData& mesh;
  ColorBy::Kind kind;
  const Theme& theme;
  const Colormap& map;
  std::string title;  ///< what the colours stand for, with its unit
  ValueRange range;
  std::size_t invalid, degenerate;
};

/// Width in pixels of the column in a picture whose drawing is `height` pixels high.
double legend_width(const Legend& legend, double height);
/// Appends the column, its upper left corner at (left, top).
void write_legend(const Legend& legend, double left, double top, double height, std::string& out);
/// Appends the stops of a gradient with the map's colours.
void gradient_stops(const Colormap& map, std::string& out);

}  // namespace pliant
