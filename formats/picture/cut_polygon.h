// formats/picture/cut_polygon.h: a polygon cut into triangles without further vertices.
#pragma once
#include <array>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// Triangles that cover a simple polygon once, all counter-clockwise: triples of indices into its corners. Of all ears
/// the best shaped one is cut off first.
///
/// Shapes      n corners counter-clockwise give n - 2 triangles; corners on a line are allowed. A polygon that crosses
///             itself gives as many, some of which overlap
/// Complexity  O(n^3) at worst; n is small
std::vector<std::array<int, 3>> cut_polygon(const std::vector<Point>& corners);

}  // namespace pliant
