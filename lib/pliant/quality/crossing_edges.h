#pragma once  // lib/pliant/quality/crossing_edges.h: pairs of curved edges that cross
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "pliant/geometry/point.h"
#include "pliant/mesh/ids.h"

namespace pliant {

/// Bézier curves of one degree.
struct EdgeCurves {
  int degree = 1;
  std::vector<Point> points;                      ///< degree + 1 an edge
  std::vector<std::pair<PointId, PointId>> ends;  ///< of each edge: equal ids are one and the same vertex

  std::span<const Point> polygon(std::size_t edge) const {
    const auto n = static_cast<std::size_t>(degree) + 1;
    return std::span(points).subspan(edge * n, n);
  }
};

/// The number of pairs of edges that meet elsewhere than at a common vertex.
///
/// Edges with a common vertex count only where they are proved to cross; others also where they touch, that is where
/// subdivision down to 1e-12 of the size cannot part them. An edge that crosses itself does not count.
/// Complexity  O(n log n + candidate pairs of boxes), pairs decided by subdivision
std::int64_t count_crossings(const EdgeCurves& edges);

}  // namespace pliant
