// lib/pliant/mesh/half_edges.h: which half-edges of a document belong together?
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "pliant/mesh/edge_uses.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// The half-edges of a document, paired. Of a document that is no proper mesh, too: there the first half-edges of
/// either direction are twins, and others in their direction have the same twin.
class HalfEdges {
 public:
  /// Requires    check_arrays(data) to be empty; the document must outlive this
  /// Complexity  O(n), plus sorting at each vertex
  explicit HalfEdges(const MeshData& data);

  /// The same without the proof, by the vertices alone: is_sound() is false.
  static HalfEdges by_vertices(const MeshData& data);

  /// True only if M1 and M2 hold (of degree 1, at pinched vertices and on surfaces with handles it is false all the
  /// same): pairing half-edges by their inner control points goes along with the proof.
  bool is_sound() const { return is_sound_; }
  HalfEdgeId twin(HalfEdgeId h) const { return twins_[static_cast<std::size_t>(h)]; }
  const std::vector<HalfEdgeId>& twins() const { return twins_; }
  /// Is there a triangle of another face on the other side, or none?
  bool is_border(HalfEdgeId h) const { return borders_[static_cast<std::size_t>(h)]; }
  /// The half-edge that runs along these control points of an edge, and the one that runs back; or none.
  std::array<HalfEdgeId, 2> along(std::span<const PointId> edge) const;
  /// By their vertices; made when first asked for.
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
  HalfEdgeId count_;
  std::vector<HalfEdgeId> twins_;
  std::vector<bool> borders_;
  bool is_sound_ = false;
  std::int64_t vertices_ = 0;
  std::vector<HalfEdgeId> use_;  // of each point, only if sound
  mutable std::optional<EdgeUses> uses_;
};

}  // namespace pliant
