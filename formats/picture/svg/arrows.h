// formats/picture/svg/arrows.h: the layer of a vector field's arrows.
#pragma once
#include <string>

#include "formats/picture/svg/drawing.h"
#include "formats/picture/svg/frame.h"

namespace pliant {

/// Appends an arrow for each point of the grid that is in the mesh. Returns the key: what a length stands for.
/// Throws      std::invalid_argument where the mesh has no such field, or it has not two components
Key draw_arrows(const Drawing& drawing, const ArrowRequest& request, std::string& out);

/// Appends the closed path data of an arrow whose shaft is `width` wide, or narrower if the arrow is short.
void write_arrow(const Point& tail, const Point& tip, double width, SvgPath& path);

}  // namespace pliant
