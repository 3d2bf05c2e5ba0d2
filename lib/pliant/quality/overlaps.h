// lib/pliant/quality/overlaps.h: does the mesh lie over itself? (private to this layer).
#pragma once
#include "pliant/mesh/half_edges.h"
#include "pliant/quality/quality_report.h"

namespace pliant {

/// Elements may each be valid while the mesh folds over itself. Where its boundary edges nowhere meet but at common
/// vertices, the number of elements over a point (turned ones counting -1) is the winding number of the outer boundary,
/// constant up to it: it must be 1 on the mesh's side of every boundary loop. So two things are looked for: pairs of
/// edges that cross or touch, and loops without such edges whose inner side is not covered just once. If there are
/// none, and all elements are valid, then no two elements overlap.
///
/// The edges looked at are constrained edges, and those with one triangle. A loop is tested beside the middle of one of
/// its edges. `most` places are listed.
/// Complexity  O(n log n + pairs of boxes that overlap + loops * boundary edges)
struct Overlaps {
  std::int64_t count = 0;
  std::vector<OverlapPlace> places;
};
Overlaps find_overlaps(const MeshData& data, const HalfEdges& half_edges, int most);

}  // namespace pliant
