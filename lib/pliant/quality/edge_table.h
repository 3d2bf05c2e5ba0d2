#pragma once  // lib/pliant/quality/edge_table.h: the edges of a document that may be no proper mesh (private here)
#include <span>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Half-edges that join the same two vertices.
struct EdgeUses {
  std::vector<HalfEdgeId> half_edges;  ///< sorted by the vertices they join, then by number
  std::vector<std::size_t> starts;     ///< edge e: half_edges[starts[e]] to half_edges[starts[e + 1] - 1]

  std::size_t count() const { return starts.size() - 1; }
  std::span<const HalfEdgeId> of(std::size_t e) const {
    return std::span(half_edges).subspan(starts[e], starts[e + 1] - starts[e]);
  }
};
/// Of the triangles that `is_chosen` names.
/// Requires    check_arrays(data) to be empty; nothing else: an edge may have any number of half-edges
/// Complexity  O(n log n)
EdgeUses edge_uses(const MeshData& data, const std::vector<bool>& is_chosen);

/// The control points of a half-edge in its direction: ids, and places.
std::vector<PointId> edge_ids(const MeshData& data, HalfEdgeId h);
std::vector<Point> edge_polygon(const MeshData& data, HalfEdgeId h);

/// Arc length of a Bézier curve, to 1e-9 relative (next to a cusp 1e-6).
double curve_length(std::span<const Point> polygon);

}  // namespace pliant
