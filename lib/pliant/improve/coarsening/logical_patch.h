// lib/pliant/improve/coarsening/logical_patch.h: some straight triangles of a mesh, copied, so that removals can be
// tried on them.
#pragma once
#include <array>
#include <utility>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/mesh/star.h"

namespace pliant {

/// A part of the logical mesh that grows as it is needed. Removals and flips here say what they would do there as long
/// as no curved element gets in the way; the mesh stays as it is.
///
/// Requires     the mesh does not change between `start` and the last use
/// Complexity   a removal: the squared degree of the vertex, plus the flips that follow; no allocation once warm
class LogicalPatch {
 public:
  using Corners = std::array<PointId, 3>;
  enum class Outcome {
    done,
    on_curve,  ///< and nothing else
    stuck,     ///< no ear can be cut, or fewer than three neighbours
    unknown    ///< too many neighbours or flips: nothing is said
  };
  struct Piece {
    Corners corners{};
    /// What is beyond each side, from corner e to the next: another piece, `wall`, or -2 - h, the mesh's half-edge h.
    std::array<int, 3> beyond{};
    std::array<bool, 3> is_constrained{};
    FaceId face = none;
    TriangleId triangle = none;  ///< the one that was copied
    bool is_alive = false;
    bool is_new = false;  ///< not a triangle of the mesh
  };
  static constexpr int wall = -1;

  explicit LogicalPatch(const Mesh& mesh) : mesh_(mesh) {}

  /// Forgets everything. `measures`: bend() is wanted.
  void start(bool measures = false) {
    pieces_.clear();
    moved_.clear();
    bend_ = 0;
    measures_ = measures;
  }
  /// Removes a vertex that is on no curve as `remove_inner_vertex` would, and flips what is not Delaunay then.
  Outcome remove_inner(PointId v);
  /// Removes a vertex that one curve passes through as `remove_curve_vertex` would; `moved` are the curve's vertices
  /// that move, and where to.
  Outcome remove_on_curve(PointId v, const std::vector<std::pair<PointId, Point>>& moved);
  /// Where a vertex is, or has moved to.
  const Point& place(PointId v) const {
    for (const auto& [moved, to] : moved_)
      if (moved == v) return to;
    return mesh_.point(v);
  }
  /// A corner of it has moved.
  bool has_moved(const Piece& piece) const;
  /// All pieces; some are dead.
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// How far the edges of the copied triangles' elements are off their chords at most, by their control points.
  double bend() const { return bend_; }

 private:
  Piece& piece(int p) { return pieces_[static_cast<std::size_t>(p)]; }
  int bring_in(TriangleId t);
  int side_towards(int p, PointId origin) const;
  void set_beyond(int p, int side, int beyond, bool is_constrained);
  int piece_at(PointId v);
  int neighbor(int p, int side);
  void turn(int p, PointId v);
  Outcome gather_ring(PointId v);
  bool gather_fan(int p, PointId v);
  bool cut_ear(bool is_closed);
  void merge_ring();
  int merge_fan();
  void bring_in_star(PointId v);
  void flip(int p, int side);
  Outcome flip_to_delaunay();

  const Mesh& mesh_;
  std::vector<Piece> pieces_;
  std::vector<std::pair<PointId, Point>> moved_;
  Star star_;
  double bend_ = 0;
  bool measures_ = false;
  std::vector<int> ring_;  // the pieces around a vertex, which is their corner 0, counter-clockwise
  std::vector<int> hole_;  // the pieces of a star, now in the hole
  std::vector<PointId> link_;
  std::vector<int> stack_;
  std::vector<std::pair<double, int>> ears_;
};

}  // namespace pliant
