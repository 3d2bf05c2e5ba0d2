// lib/pliant/mesh/half_edges.h: which half-edges of a document are twins.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "pliant/mesh/edge_uses.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The half-edges of a document, paired to twins. The document may break M1 and M2. Where more than two half-edges join
/// the same two vertices, the first one in each direction are twins, and each further one has the same twin as the
/// first one of its direction.
class HalfEdges {
 public:
  /// Requires    check_arrays(data) to be empty; the document must outlive this
  /// Complexity  O(n), plus sorting at each vertex
  explicit HalfEdges(const MeshData& data);

  /// The same pairs, found by comparing vertices alone. That proves nothing: is_sound() is false.
  static HalfEdges by_vertices(const MeshData& data);

  /// True if M1 and M2 are proved to hold: pairing half-edges by their inner control points proves it on the way.
  /// False also for some meshes that satisfy both: those of degree 1, with pinched vertices, or with handles.
  bool is_sound() const { return is_sound_; }
  HalfEdgeId twin(HalfEdgeId h) const { return twins_[index(h)]; }
  const std::vector<HalfEdgeId>& twins() const { return twins_; }
  /// True if the other side of h has a triangle of another face, or no triangle.
  bool is_border(HalfEdgeId h) const { return borders_[index(h)]; }
  /// The half-edge from the first to the last of an edge's control points, and the one back; each may be none.
  std::array<HalfEdgeId, 2> along(std::span<const PointId> edge) const;
  /// The half-edges grouped by their vertices; made when first asked for.
  const EdgeUses& uses() const;

 private:
  HalfEdges(const MeshData& data, bool by_vertices);
  bool pair_by_inner_points();
  void fetch_for(TriangleId t) const;
  bool is_each_star_simple() const;
  bool is_each_edge_the_only_one() const;
  void pair_by_vertices();
  PointId entry(TriangleId t, int k) const {
    return data_->triangles[static_cast<std::size_t>(t) * n_ + static_cast<std::size_t>(k)];
  }
  PointId origin(HalfEdgeId h) const { return entry(triangle_of(h), edge_of(h)); }
  PointId target(HalfEdgeId h) const { return origin(next(h)); }

  const MeshData* data_;
  std::size_t n_;
  TriangleId triangles_;
  std::vector<HalfEdgeId> twins_;
  std::vector<bool> borders_;
  bool is_sound_ = false;
  std::int64_t vertices_ = 0;
  std::vector<std::int32_t> use_;  // what each point is used for (coded in half_edges.cpp); empty unless sound
  mutable std::optional<EdgeUses> uses_;
};

}  // namespace pliant
