// lib/pliant/improve/refining/tame.h: makes logical triangles positive that are turned over, by straightening, flipping
// and cutting.
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
  long splits = 0;        ///< inner edges that were split
  long curve_splits = 0;  ///< edges on curves that were split: knots inserted
  long left = 0;          ///< logical triangles that are still not positive
};

/// Makes the logical triangles of valid elements positive. Edges around a triangle that is turned over are
/// straightened, and flipped where that makes both triangles positive. Where that does not help the element is cut in
/// two at the middle of an edge. Such a cut is exact subdivision: geometry and fields stay. Since det J > 0 on the
/// closed element, small pieces are nearly affine, and their logical triangles are positive.
///
/// Where a flip is refused to an edge that is not Delaunay, bends are in the way: a curve beside it that bends much is
/// split, or an element beside it with a bent inner edge is cut.
///
/// Each element has a *reference triangle*, which starts out equilateral and is cut along with the element. An element
/// is cut across the longest edge of its reference triangle; among equally long ones, across the edge that bends most.
/// A neighbour that has a longer edge is cut first (Rivara's longest-edge bisection). So the references of the pieces
/// belong to few similarity classes, and how uneven the element's derivative is bounds the number of cuts. The
/// reference starts anew where a flip or a moved edge has changed the element.
///
/// Elements in a narrow wedge between two curves are left alone: there refinement splits both sides alike.
class Tamer {
 public:
  Tamer(Mesh& mesh, const RefitOptions& refit, LegalizeCounts& flips)
      : mesh_(mesh), refit_(refit), flips_(flips), corners_(mesh) {}

  /// Works on these elements and on the pieces that they become, one level of cuts after the other. Cuts nothing once
  /// the mesh has `max_triangles`.
  ///
  /// Complexity  O(elements + pieces)
  TameCounts tame(std::vector<TriangleId> seeds, long max_triangles);

 private:
  using Corners = std::array<PointId, 3>;
  struct Piece {
    Corners corners;                    ///< when these differ from the element's, the piece is out of date
    std::array<Barycentric, 3> places;  ///< the places of the corners in the equilateral triangle
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
