// lib/pliant/improve/coarsening/removal_forecast.h: foretells that the removal of a vertex must fail, before the mesh
// is touched.
#pragma once
#include <cmath>
#include <tuple>
#include <vector>

#include "pliant/improve/coarsening/logical_patch.h"
#include "pliant/improve/sizing.h"
#include "pliant/ops/remove_point.h"

namespace pliant {

inline constexpr int most_chained = 12;  ///< the most removals in a chain, which mend each other's elements

/// Why a removal is refused: the words of the operation, or why `refine` would attack what is left.
struct RemovalRefusal {
  const char* reason = nullptr;  ///< null: not refused
  bool is_refinement = false;    ///< `reason` is why refine would attack
};

/// Why `refine` would attack this triangle; null if it would not. Coarsening asks that here and nowhere else.
const char* attack_reason(const Mesh& mesh, TriangleId t, const QualityGoals& goals);

/// The corner that should be removed to get rid of a triangle which refine would attack. It is the first slated one of
/// these: the origin of the shortest side, its target, the corner opposite.
struct Culprit {
  PointId vertex = none;                              ///< none: no corner is slated
  double side = HUGE_VAL;                             ///< squared length of the shortest side
  std::array<PointId, 3> triangle{none, none, none};  ///< its corners in ascending order

  /// The triangle with the shortest side is mended first, in whatever order the triangles are found.
  friend auto operator<=>(const Culprit& a, const Culprit& b) {
    return std::tie(a.side, a.triangle) <=> std::tie(b.side, b.triangle);
  }
};
/// Finds the culprit of the triangle with these corners, as if they were at these places.
Culprit find_culprit(const Mesh& mesh, const std::array<PointId, 3>& corners, const std::array<Point, 3>& places,
                     const std::vector<bool>& slated);

/// Tries removals on the logical triangles alone.
///
/// A removal in the logical mesh ends in the constrained Delaunay triangulation of the region that it changes. No other
/// triangulation of the region has a greater least angle. So if that one has a triangle which refine would attack, and
/// no slated corner to mend it, the removal on curved elements would be rolled back, too, since fewer flips are
/// possible there. Bounds on area allow for what bent sides can hold.
///
/// Only what is certain is refused. Elements that might become invalid or misshapen are not looked for, nor are areas
/// compared once a curve has lost a knot.
class RemovalForecast {
 public:
  /// `slated`: by point slot, what may go.
  RemovalForecast(Mesh& mesh, const QualityGoals& goals, const CurveTolerance& tolerance,
                  const std::vector<bool>& slated);

  /// Why the removal of v (is it on a curve?) is bound to fail, followed by removals of other slated vertices as long
  /// as refine would attack what is left; no reason if it may succeed.
  ///
  /// Complexity  the sum of the squared degrees of the vertices in the chain
  RemovalRefusal of(PointId v, bool is_on_curve);
  /// Says that a vertex was removed from a curve of the mesh, so that what the curve has refused may have changed.
  void forget(CurveId c) { ++versions_[index(c)]; }
  /// The vertices that decided the last answer: by the triangles around them, and by which of them are slated.
  const std::vector<PointId>& decided_by() const { return patch_.vertices(); }

 private:
  const char* reason_of(const LogicalPatch::Piece& piece) const;
  bool is_surely_poor(const Point& a, const Point& b, const Point& c) const;
  bool exceeds_area(FaceId face, const Point& a, const Point& b, const Point& c, double share) const;
  bool leaves_too_large() const;
  bool is_surely_large(FaceId face, const std::array<PointId, 3>& corners, const Point& a, const Point& b,
                       const Point& c) const;
  LogicalPatch::Outcome remove(PointId w, bool is_surely_on_curve, Outcome& reason);
  Outcome ask_curve(PointId w);

  Mesh& mesh_;  // left as it was by each question
  const QualityGoals& goals_;
  const CurveTolerance& tolerance_;
  const std::vector<bool>& slated_;
  LogicalPatch patch_;
  ForeseenCurves foreseen_;
  /// What its curve said when it refused the removal of a vertex: many are asked for again and again, in chains that
  /// start at the vertices around.
  struct Refusal {
    CurveId curve = none;
    int version = 0;  ///< of the curve then
    Outcome outcome = Outcome::done;
  };
  const Refusal* known_refusal(PointId w) const;
  std::vector<Refusal> refused_;  // by point slot
  std::vector<int> versions_;     // by curve: how often it was forgotten
  double least_sine_ = 0;
  bool bounds_area_ = false, is_size_asked_ = false, is_poor_asked_ = false;
};

}  // namespace pliant
