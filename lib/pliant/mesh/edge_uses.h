// lib/pliant/mesh/edge_uses.h: the edges of a document that may be no proper mesh.
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Half-edges grouped by the two vertices that they join: an edge of a sound mesh has one or two, of a broken document
/// any number. Edges ascend by their lower vertex, then by the higher one; the half-edges of one edge ascend, too.
struct EdgeUses {
  std::vector<HalfEdgeId> half_edges;
  std::vector<std::int32_t> starts;  ///< edge e: half_edges[starts[e]] to half_edges[starts[e + 1] - 1]
  std::vector<std::int32_t>
      first_edge;  ///< for each point its first edge as the lower vertex; one more entry at the end

  std::size_t count() const { return starts.size() - 1; }
  std::span<const HalfEdgeId> of(std::size_t e) const {
    const auto first = static_cast<std::size_t>(starts[e]);
    return std::span(half_edges).subspan(first, static_cast<std::size_t>(starts[e + 1]) - first);
  }
  /// The half-edges that join these vertices, in either direction.   Complexity  O(log edges of the lower vertex)
  std::span<const HalfEdgeId> between(const MeshData& data, PointId a, PointId b) const;
};

/// Groups the half-edges of a document.
///
/// Requires    check_arrays(data) to be empty; nothing else
/// Complexity  O(n), plus sorting at each vertex
EdgeUses edge_uses(const MeshData& data);

}  // namespace pliant
