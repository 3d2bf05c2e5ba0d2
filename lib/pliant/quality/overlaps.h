// lib/pliant/quality/overlaps.h: finds where a mesh lies over itself (private to this layer).
#pragma once
#include "pliant/mesh/half_edges.h"
#include "pliant/quality/quality_report.h"

namespace pliant {

/// Places where a mesh lies over itself. That may happen even if each of its elements is valid.
///
/// The number of elements over a point, where inverted ones count -1, is the winding number of the outer boundary
/// around it. If boundary edges meet at common vertices only, that number is the same all along a boundary loop, and on
/// the mesh's side it must be 1. So two things are listed: pairs of edges that cross or touch, and loops without such
/// edges whose inner side is not covered exactly once. If there are none, and all elements are valid, no two elements
/// overlap.
///
/// Constrained edges and edges with one triangle are tested for crossings. A loop is tested at a point beside the
/// middle of one of its edges.
struct Overlaps {
  std::int64_t count = 0;
  std::vector<OverlapPlace> places;
};
/// Counts all overlaps and lists the first `most` of them.
/// Complexity  O(n log n + pairs of boxes that overlap + loops * boundary edges)
Overlaps find_overlaps(const MeshData& data, const HalfEdges& half_edges, int most);

}  // namespace pliant
