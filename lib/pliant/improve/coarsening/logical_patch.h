// lib/pliant/improve/coarsening/logical_patch.h: copies of some logical triangles of a mesh, on which removals are
// tried.
#pragma once
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/star.h"

namespace pliant {

/// A copy of a part of the logical mesh, which grows as needed. Removals and flips on it show what they would do to the
/// mesh, as long as no curved element gets in the way. The mesh stays as it is.
///
/// Requires    the mesh does not change between `start` and the last use
/// Complexity  a removal costs the squared degree of the vertex, plus the flips that follow; memory is reused
class LogicalPatch {
 public:
  using Corners = std::array<int, 3>;  ///< by the patch's own numbers of vertices
  enum class Outcome {
    done,
    on_curve,  ///< the vertex is on a curve, and nothing was done
    stuck,     ///< no ear can be cut, or the vertex has fewer than three neighbours
    unknown    ///< too many neighbours or flips: no answer
  };
  struct Piece {
    Corners corners{};
    /// What lies beyond side e, which runs from corner e to the next one: the number of another piece, `wall` (the
    /// outer boundary), or -2 - h, where h is a half-edge of the mesh whose triangle was not copied yet.
    std::array<int, 3> beyond{};
    std::array<bool, 3> is_constrained{};
    std::array<bool, 3> is_settled{};  ///< the side needs no flip as long as the triangles on it stay
    bool is_alive = false;
    bool is_new = false;  ///< a removal or flip has made it: it is no triangle of the mesh
    FaceId face = none;
    TriangleId triangle = none;  ///< the triangle of the mesh that was copied
  };
  static constexpr int wall = -1;

  explicit LogicalPatch(const Mesh& mesh) : mesh_(mesh) {}

  /// Forgets everything. `measures` says whether bend() is wanted.
  void start(bool measures = false) {
    pieces_.clear();
    vertices_.clear();
    places_.clear();
    moved_.clear();
    squared_bend_ = 0;
    measures_ = measures;
  }
  /// Removes a vertex that is on no curve as `remove_inner_vertex` would, then flips the sides that are not Delaunay.
  Outcome remove_inner(PointId v);
  /// The same for a vertex that one curve passes through, as `remove_curve_vertex` would. `moved` lists the vertices of
  /// the curve that move, and where to.
  Outcome remove_on_curve(PointId v, const std::vector<std::pair<PointId, Point>>& moved);
  /// The vertices of all pieces, each once; a corner is the place of a vertex in this list.
  const std::vector<PointId>& vertices() const { return vertices_; }
  std::array<PointId, 3> vertices(const Piece& piece) const {
    return {vertices_[index(piece.corners[0])], vertices_[index(piece.corners[1])], vertices_[index(piece.corners[2])]};
  }
  /// Where a corner is, or has moved to.
  const Point& place(int corner) const { return places_[index(corner)]; }
  std::array<Point, 3> places(const Piece& piece) const {
    return {place(piece.corners[0]), place(piece.corners[1]), place(piece.corners[2])};
  }
  /// Has a corner of this piece moved?
  bool has_moved(const Piece& piece) const;
  /// All pieces, those included that are no longer alive.
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// The greatest bend of the edges of all copied elements: how far a control point is from where it would be if its
  /// edge were straight.
  double bend() const { return std::sqrt(squared_bend_); }

 private:
  static int outside_piece(HalfEdgeId h) { return -2 - as_int(h); }
  static HalfEdgeId half_edge_of(int beyond) { return HalfEdgeId{-2 - beyond}; }
  Piece& piece(int p) { return pieces_[index(p)]; }
  int number_of(PointId v) const;
  int add_vertex(PointId v);
  Point place_of(PointId v) const;
  int bring_in(TriangleId t);
  int bring_in_beside(int p, int side);
  int copy(TriangleId t, const Corners& corners);
  void join(int p, const std::array<bool, 3>& sides);
  int side_towards(int p, int corner) const;
  void set_beyond(int p, int side, int beyond, bool is_constrained);
  int piece_at(PointId v);
  int neighbor(int p, int side) {
    const int beyond = piece(p).beyond[index(side)];
    return beyond >= 0 ? beyond : bring_in_beside(p, side);
  }
  void turn(int p, int corner);
  Outcome gather_ring(PointId v);
  bool gather_fan(int p, int corner);
  bool reduce_ring(bool is_closed, int least);
  void merge_ring();
  int merge_fan();
  void bring_in_star(PointId v);
  void flip(int p, int side);
  bool wants_flip(int p, int side);
  Outcome flip_to_delaunay();

  const Mesh& mesh_;
  std::vector<Piece> pieces_;
  std::vector<PointId> vertices_;
  std::vector<Point> places_;
  std::vector<std::pair<PointId, Point>> moved_;
  Star star_;
  double squared_bend_ = 0;
  bool measures_ = false;
  std::vector<int> ring_;  // the pieces around a vertex, which is their corner 0, counter-clockwise
  std::vector<int> hole_;  // the pieces that were around the removed vertex
  // See reduce_ring:
  std::vector<Point> link_;
  std::vector<double> ears_;
  std::vector<PointId> rim_;
  std::vector<int> stack_;
};

}  // namespace pliant
