#pragma once  // lib/pliant/generate/triangulate_boundary.h: constrained Delaunay triangulation of a planar
              // straight-line graph
#include <array>
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// Triangles (counter-clockwise vertex indices) of the constrained Delaunay triangulation of the points' convex hull in
/// which every segment is an edge. Exact predicates. Requires segments that do not cross and pass through no other
/// point; distinct points. Throws      std::invalid_argument, naming the segments or points, where that is not so
/// Complexity  O(n log n) expected
std::vector<std::array<int, 3>> triangulate(std::span<const Point> points,
                                            std::span<const std::array<int, 2>> segments);

}  // namespace pliant
