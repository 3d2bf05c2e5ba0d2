// lib/pliant/improve/refining/sharp_corners.h: small angles of the boundary, and shells around them.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/mesh/star.h"

namespace pliant {

/// The vertices where two curves, or the two ends of one, enclose less than 60 degrees of a face (zero at a cusp), and
/// the *sides* that lead to them: stretches of curves between two vertices at which a curve ends, branches or has such
/// an angle. Between two sides of one corner lies its *wedge*. Edges there are split at equal distances from the
/// corner, or at distances that are powers of two, so that both sides get vertices on the same shells and no two spans
/// encroach on each other again and again. An edge from one side to the other is as short as the angle demands:
/// triangles whose shortest edge it is cannot be mended.
///
/// Reference   Cheng, Dey, Shewchuk, Delaunay mesh generation (seditious edges); Shewchuk, Mesh generation for domains
///             with small angles
class SharpCorners {
 public:
  /// Complexity  O(mesh)
  explicit SharpCorners(const Mesh& mesh);

  bool empty() const { return corners_.empty(); }
  bool contains(PointId v) const { return corners_.count(v) > 0; }
  /// The corner of the face in whose wedge the two vertices lie on two different sides; or none. Of several corners the
  /// one from which the angle between the two is least.   Complexity O(1)
  PointId shared(const Mesh& mesh, PointId p, PointId q, FaceId f) const;
  /// The same, where the wedge is so narrow there that it is left as it is.
  PointId narrow_wedge(const Mesh& mesh, PointId p, PointId q, FaceId f) const;
  /// Is this the shortest edge of a poor triangle that its wedge excuses? The edge's ends lie on two sides, at
  /// distances from the corner in a ratio of at most 2; and the wedge is so narrow there that triangles of its own
  /// width would be without number, or the edge runs along a shell and the corner is no further than the triangle
  /// reaches.
  bool excuses(const Mesh& mesh, HalfEdgeId shortest, double longest) const;
  /// Distance from its corner at which an edge on a side is split so that the vertex opposite, on the other side, has
  /// its like: `corner` is none where there is no such vertex.
  struct Mirror {
    PointId corner = none;
    double radius = 0;
  };
  Mirror mirror(const Mesh& mesh, HalfEdgeId h) const;
  /// A vertex that splits an edge between two others belongs to their side.
  void add_between(PointId v, PointId first, PointId last);

 private:
  using SideId = std::int32_t;
  struct Side {
    std::array<PointId, 2> corners{none, none};  // that it leads to, of those that are sharp
  };
  void find_corners(const Mesh& mesh);
  void find_sides(const Mesh& mesh);
  void follow(const Mesh& mesh, PointId from, PointId to, const std::vector<char>& is_node);
  SideId side_of(PointId v) const {
    return static_cast<std::size_t>(v) < sides_of_.size() ? sides_of_[static_cast<std::size_t>(v)] : none;
  }
  /// The sides that a vertex lies on; a node lies on those that end there.
  std::span<const SideId> all_sides_of(PointId v, SideId& storage) const;
  static std::uint64_t key(PointId a, PointId b) {
    if (a > b) std::swap(a, b);
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
  }

  std::unordered_map<PointId, FaceId> corners_;  // and the face, or `several`
  std::vector<Side> sides_;
  std::vector<SideId> sides_of_;  // by point slot; none at nodes, and where no corner is reached
  std::unordered_map<PointId, std::vector<SideId>> ending_at_;  // nodes: the sides that end there
  std::unordered_map<std::uint64_t, SideId> one_edge_;          // sides that are a single edge between two nodes
};

}  // namespace pliant
