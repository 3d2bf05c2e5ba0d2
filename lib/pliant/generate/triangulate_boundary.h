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

/// Two points are the same, or a segment crosses another one or passes through a point. The text names points by index
/// and coordinates; a caller who knows what they are can make a better one of the members.
class TriangulationError : public std::invalid_argument {
 public:
  TriangulationError(const std::string& text, std::array<int, 2> pair, std::string says, std::vector<int> rest)
      : std::invalid_argument(text), points(pair), how(std::move(says)), others(std::move(rest)) {}

  std::array<int, 2> points;  ///< the points that are the same, or that a segment was to join
  std::string how;            ///< what is wrong with them: "are the same point", "are joined by a segment through"
  std::vector<int> others;    ///< the points that the segment meets
};

/// The constrained Delaunay triangulation of the convex hull of the points, in which every segment is an edge. Its
/// predicates are exact. Returns the triangles as indices of points, counter-clockwise.
///
/// Throws      TriangulationError where two points are the same, or a segment crosses another one or passes through a
///             point; std::invalid_argument where a point is not finite
/// Complexity  O(n log n) expected
std::vector<std::array<int, 3>> triangulate(std::span<const Point> points,
                                            std::span<const std::array<int, 2>> segments);

}  // namespace pliant
