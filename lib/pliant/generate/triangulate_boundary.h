// lib/pliant/generate/triangulate_boundary.h: constrained Delaunay triangulation of a planar straight-line graph.
#pragma once
#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// Points that coincide, or segments that cross or pass through a point. The text tells points by index and
/// coordinates; who knows what they are can tell it better.
class TriangulationError : public std::invalid_argument {
 public:
  TriangulationError(const std::string& text, std::array<int, 2> pair, std::string says, std::vector<int> rest)
      : std::invalid_argument(text), points(pair), how(std::move(says)), others(std::move(rest)) {}

  std::array<int, 2> points;  ///< that are equal, or were to be joined
  std::string how;            ///< "are the same point", "are joined by a segment through" the others
  std::vector<int> others;
};

/// Triangles (counter-clockwise vertex indices) of the constrained Delaunay triangulation of the points' convex hull in
/// which every segment is an edge. Exact predicates. Requires segments that do not cross and pass through no other
/// point; distinct, finite points. Throws      TriangulationError or std::invalid_argument where that is not so
/// Complexity  O(n log n) expected
std::vector<std::array<int, 3>> triangulate(std::span<const Point> points,
                                            std::span<const std::array<int, 2>> segments);

}  // namespace pliant
