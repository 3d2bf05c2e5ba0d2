// lib/pliant/quality/crossing_edges.h: pairs of curved edges that cross.
#pragma once
#include <cstddef>
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

/// Two edges that meet elsewhere than at a common vertex.
struct Crossing {
  std::size_t first, second;
  Point place;
};

/// All pairs of edges that meet elsewhere than at a common vertex: that cross, touch, or are closer than 1e-11 of their
/// size, as check_boundary_geometry has it; ascending, and at most `most` of them. A cusp at a common vertex does not
/// count, nor does an edge that crosses itself.
/// Complexity  O(n log n + pairs of boxes that overlap), pairs decided by subdivision
std::vector<Crossing> find_crossings(const EdgeCurves& edges, std::size_t most = 100'000);

}  // namespace pliant
