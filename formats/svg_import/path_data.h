// formats/svg_import/path_data.h: the path data of an SVG path.
#pragma once
#include <string_view>

#include "formats/svg_import/areas/outline.h"

namespace pliant::svg {

/// Reads path data (the attribute `d`): all commands, absolute and relative. Empty data and "none" give no outline.
///
/// Throws      SyntaxError at the first character that is none of the grammar; unlike a browser, which would draw what
///             stands before it
/// Complexity  O(characters)
Outline parse_path_data(std::string_view d);

/// The points of a polyline or polygon. Throws SyntaxError, also for an odd count.
Outline parse_points(std::string_view points);

}  // namespace pliant::svg
