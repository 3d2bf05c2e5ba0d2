// lib/pliant/improve/refining/tame.h: straight triangles that are turned over become positive: edges straightened,
// flipped, cut.
#pragma once
#include <array>
#include <unordered_map>
#include <vector>

#include "pliant/improve/legalize.h"
#include "pliant/improve/refining/sharp_corners.h"
#include "pliant/mesh/mesh.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct TameCounts {
  long splits = 0;        ///< inner edges
  long curve_splits = 0;  ///< edges on curves: knots inserted
  long left = 0;          ///< straight triangles that are still not positive
};

/// Makes the straight triangles of valid elements positive, and their edges Delaunay as far as bends are in the way of
/// that. Edges around a triangle that is turned over are straightened, and flipped where that makes both triangles
/// positive; where it stays so the element is cut in two at an edge's middle. This is exact subdivision: geometry and
/// fields stay. Since det J > 0 on the closed element, small pieces are nearly affine, and their straight triangles are
/// positive. Beside a flip that was refused a curve that bends much is split, or an element with a bent edge cut.
///
/// An element is cut across the longest edge of its *reference triangle*, which starts out equilateral and is cut along
/// with it; among equal ones across the one that bends most. The neighbour is cut first where it has a longer one
/// (Rivara's longest-edge bisection), so that the pieces' references belong to few similarity classes and the depth is
/// bounded by how uneven the element's derivative is. An element that an edge's move or flip has changed starts anew.
///
/// What lies in a narrow wedge between two curves is left alone: there refinement splits both sides alike.
class Tamer {
 public:
  Tamer(Mesh& mesh, const RefitOptions& refit, LegalizeCounts& flips)
      : mesh_(mesh), refit_(refit), flips_(flips), corners_(mesh) {}

  /// Works on these elements, one level of cuts after the other, and on what comes of them, as long as there are no
  /// more than `max_triangles`.
  ///
  /// Complexity  O(elements given + pieces made)
  TameCounts tame(std::vector<TriangleId> seeds, long max_triangles);

 private:
  using Corners = std::array<PointId, 3>;
  struct Piece {
    Corners corners;
    std::array<Barycentric, 3> places;  ///< of the corners, in the reference triangle
  };

  bool is_wild(TriangleId t) const;
  bool is_in_wedge(TriangleId t) const;
  void straighten_and_flip(const std::vector<TriangleId>& seeds);
  bool cut(TriangleId t);
  bool unbend_beside(const RefusedEdge& edge);
  bool split(HalfEdgeId h);
  Piece& piece(TriangleId t);
  double reference_length(HalfEdgeId h);
  HalfEdgeId edge_to_cut(TriangleId t);

  Mesh& mesh_;
  const RefitOptions& refit_;
  LegalizeCounts& flips_;
  SharpCorners corners_;
  TameCounts counts_;
  std::unordered_map<TriangleId, Piece> pieces_;
  std::vector<TriangleId> changed_;
  std::vector<RefusedEdge> refused_;
};

}  // namespace pliant
