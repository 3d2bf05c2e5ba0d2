// lib/pliant/quality/crossing_edges.h: pairs of curved edges that cross.
#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "pliant/geometry/point.h"
#include "pliant/mesh/ids.h"

namespace pliant {

/// Edges as Bézier curves, all of one degree.
struct EdgeCurves {
  int degree = 1;
  std::vector<Point> points;                      ///< degree + 1 for each edge
  std::vector<std::pair<PointId, PointId>> ends;  ///< the vertices that each edge joins

  std::span<const Point> polygon(std::size_t edge) const {
    const auto n = static_cast<std::size_t>(degree) + 1;
    return std::span(points).subspan(edge * n, n);
  }
};

/// Two edges that meet elsewhere than at a common vertex.
struct Crossing {
  std::size_t first, second;
  Point place;
};

/// All pairs of edges that meet elsewhere than at a common vertex, ascending, but at most `most` of them. Edges meet if
/// they cross, touch, or are closer than 1e-11 of their size (check_boundary_geometry has the same tolerance). A cusp
/// at a common vertex does not count, nor does an edge that crosses itself.
///
/// Complexity  O(n log n + pairs of boxes that overlap); each such pair is decided by subdivision
std::vector<Crossing> find_crossings(const EdgeCurves& edges, std::size_t most = 100'000);

}  // namespace pliant
