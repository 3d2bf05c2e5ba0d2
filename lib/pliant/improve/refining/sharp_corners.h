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

/// The sharp corners of a mesh: the vertices where two curves, or the two ends of one, enclose less than 60 degrees of
/// a face (zero at a cusp). *Sides* lead to them: stretches of curves between two *nodes*, which are vertices where a
/// curve ends or branches, and corners. Between two sides of one corner lies a *wedge*.
///
/// Edges on sides are split at the same distance from the corner as a vertex opposite, or at a power of two. So both
/// sides get vertices on the same *shells* around the corner, and no two spans encroach on each other again and again.
/// An edge from one side to the other is as short as the angle demands: triangles whose shortest edge it is cannot be
/// mended, and are excused.
///
/// Reference   Cheng, Dey, Shewchuk, Delaunay mesh generation (seditious edges); Shewchuk, Mesh generation for domains
///             with small angles
class SharpCorners {
 public:
  /// Complexity  O(mesh)
  explicit SharpCorners(const Mesh& mesh);

  bool empty() const { return corners_.empty(); }
  /// Is this vertex a sharp corner?
  bool contains(PointId v) const { return corners_.count(v) > 0; }
  /// The corner in face f between two of whose sides the vertices p and q lie, or none. Among several corners it is the
  /// one from which the angle between the two vertices is least.
  ///
  /// Complexity  O(1)
  PointId shared(const Mesh& mesh, PointId p, PointId q, FaceId f) const;
  /// The same, but none where the wedge is not so narrow there that it is left as it is.
  PointId narrow_wedge(const Mesh& mesh, PointId p, PointId q, FaceId f) const;
  /// Does a wedge excuse the poor triangle at this half-edge, which is the shortest of the triangle's edges? (`longest`
  /// is the length of the longest one.) The ends of the shortest edge must lie on two sides of a corner. Then the wedge
  /// excuses the triangle
  /// - where it is so narrow that triangles of its own width would be without number, if the larger distance of the two
  ///   ends from the corner is at most 2.1 times the smaller;
  /// - elsewhere where the edge runs along a shell, and the corner is within reach of the triangle.
  bool excuses(const Mesh& mesh, HalfEdgeId shortest, double longest) const;
  /// Where to split an edge on a side so that the new vertex is as far from the corner as the vertex opposite, which
  /// lies on the other side of the wedge. `corner` is none where there is no such vertex.
  struct Mirror {
    PointId corner = none;
    double radius = 0;  ///< the distance from the corner
  };
  Mirror mirror(const Mesh& mesh, HalfEdgeId h) const;
  /// Says that v has split the edge on a curve between two other vertices: it now belongs to their side.
  void add_between(PointId v, PointId first, PointId last);

 private:
  using SideId = std::int32_t;
  struct Side {
    std::array<PointId, 2> corners{none, none};  // the sharp corners that it leads to
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

  std::unordered_map<PointId, FaceId> corners_;  // the sharp corners, with their face, or `several`
  std::vector<Side> sides_;
  std::vector<SideId> sides_of_;  // by point slot; none at nodes, and where no corner is reached
  std::unordered_map<PointId, std::vector<SideId>> ending_at_;  // by node: the sides that end there
  std::unordered_map<std::uint64_t, SideId> one_edge_;          // sides that are a single edge between two nodes
};

}  // namespace pliant
