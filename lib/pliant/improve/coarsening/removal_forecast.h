// lib/pliant/improve/coarsening/removal_forecast.h: is the removal of a vertex bound to fail? Decided before the mesh
// is touched.
#pragma once
#include <cmath>
#include <tuple>
#include <vector>

#include "pliant/improve/coarsening/logical_patch.h"
#include "pliant/improve/sizing.h"
#include "pliant/ops/remove_point.h"

namespace pliant {

inline constexpr int most_chained = 12;  ///< removals that may mend each other's elements

/// Why a removal is refused: the words of the operation, or why `refine` would attack what is left.
struct RemovalRefusal {
  const char* reason = nullptr;  ///< null: not refused
  bool is_refinement = false;    ///< `reason` is that of an attack
};

/// Why `refine` would attack this triangle and not leave it; null if it would not. The one place in which coarsening
/// asks that.
const char* attack_reason(const Mesh& mesh, TriangleId t, const QualityGoals& goals);

/// The corner, at these places, that should go so that a triangle which refine would attack does: one that is slated,
/// the origin of the shortest side first, then its target, then the corner opposite; or none.
struct Culprit {
  PointId vertex = none;
  double side = HUGE_VAL;                             ///< squared length of the shortest side
  std::array<PointId, 3> triangle{none, none, none};  ///< in the order of their numbers

  /// Which triangle is mended first, whatever order they are found in: the one with the shortest side.
  friend auto operator<=>(const Culprit& a, const Culprit& b) {
    return std::tie(a.side, a.triangle) <=> std::tie(b.side, b.triangle);
  }
};
Culprit find_culprit(const Mesh& mesh, const std::array<PointId, 3>& corners, const std::array<Point, 3>& places,
                     const std::vector<bool>& slated);

/// Tries removals on the straight triangles alone.
///
/// A removal that keeps to the logical mesh ends in the constrained Delaunay triangulation of the region that it
/// changes, whose least angle no other triangulation of the region exceeds. So where that has a triangle which refine
/// would attack, and no slated corner to mend it, the removal on curved elements would be rolled back, too: their flips
/// can only be fewer. Sizes allow for what bent sides can hold. Whatever is not certain is not refused: curves that
/// move vertices, elements that could become invalid or misshapen.
class RemovalForecast {
 public:
  /// `slated`: by point slot, what may go.
  RemovalForecast(Mesh& mesh, const QualityGoals& goals, const CurveTolerance& tolerance,
                  const std::vector<bool>& slated);

  /// Why removing v, and then others that are slated as long as refine would attack what is left, is bound to fail; or
  /// no reason.
  ///
  /// Complexity   the sum of the squared degrees of the vertices in the chain
  RemovalRefusal of(PointId v);
  /// What decided the last answer: the corners of these pieces, and which of them were slated.
  const LogicalPatch& patch() const { return patch_; }

 private:
  const char* reason_of(const LogicalPatch::Piece& piece) const;
  bool is_surely_poor(const Point& a, const Point& b, const Point& c) const;
  bool is_surely_large(FaceId face, const LogicalPatch::Corners& corners, const Point& a, const Point& b,
                       const Point& c) const;
  LogicalPatch::Outcome remove(PointId w, Outcome& reason);

  Mesh& mesh_;  // as it was after each question
  const QualityGoals& goals_;
  const CurveTolerance& tolerance_;
  const std::vector<bool>& slated_;
  LogicalPatch patch_;
  ForeseenCurves foreseen_;
  double least_sine_ = 0;
  bool bounds_area_ = false, is_poor_asked_ = false;
};

}  // namespace pliant
