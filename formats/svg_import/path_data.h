// formats/svg_import/path_data.h: the path data of an SVG path.
#pragma once
#include <string_view>

#include "formats/svg_import/areas/outline.h"

namespace pliant::svg {

/// Reads path data (the attribute `d`): all commands, absolute and relative. Empty data and "none" give no outline.
///
/// Throws      SyntaxError at the first character that the grammar does not allow there; a browser would draw what
///             stands before it
/// Complexity  O(characters)
Outline parse_path_data(std::string_view d);

/// The outline of a polyline or polygon from its points. Throws SyntaxError, also for an odd count of coordinates.
Outline parse_points(std::string_view points);

}  // namespace pliant::svg
