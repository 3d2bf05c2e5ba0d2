// formats/picture/svg/isolines.h: the layer of a field's isolines.
#pragma once
#include <string>

#include "formats/picture/svg/drawing.h"
#include "formats/picture/svg/frame.h"

namespace pliant {

/// Appends the isolines of one request, the `number`-th from 0. Returns their key.
/// Throws      std::invalid_argument where the mesh has no such field
Key draw_isolines(const Drawing& drawing, const IsolineRequest& request, std::size_t number, std::string& out);

}  // namespace pliant
