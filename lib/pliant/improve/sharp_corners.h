#pragma once  // lib/pliant/improve/sharp_corners.h: small angles of the boundary, and shells around them
#include <unordered_map>

#include "pliant/mesh/mesh.h"
#include "pliant/mesh/star.h"

namespace pliant {

/// The vertices where two curves, or the two ends of one, enclose less than 60 degrees of a face (zero at a cusp).
/// Around them edges are split at distances that are powers of two, so that both curves get vertices on the same shells
/// and no two spans encroach on each other again and again. An edge from one curve to the other along a shell is as
/// short as the angle demands: triangles whose shortest edge it is cannot be mended.
class SharpCorners {
 public:
  /// Complexity  O(mesh)
  explicit SharpCorners(const Mesh& mesh);

  bool empty() const { return corners_.empty(); }
  bool contains(PointId v) const { return corners_.count(v) > 0; }
  /// The corner of the face of which the two vertices lie on two sides; or none.
  PointId shared(const Mesh& mesh, PointId p, PointId q, FaceId f) const;
  /// Is this edge of a triangle along a shell, and the corner no further than the triangle reaches?
  bool is_along_shell(const Mesh& mesh, HalfEdgeId h, double longest) const;

 private:
  struct Side {
    PointId corner = none;
    PointId first = none;  // vertex next to the corner, on the way
  };
  int sides_from(const Mesh& mesh, PointId p, Side sides[2]) const;

  std::unordered_map<PointId, FaceId> corners_;  // and the face, or `several`
  mutable Star star_;
};

}  // namespace pliant
