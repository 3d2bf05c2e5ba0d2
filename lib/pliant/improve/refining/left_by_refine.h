// lib/pliant/improve/refining/left_by_refine.h: the triangles that refine gives up, and whether removals let it mend
// them.
#pragma once
#include <array>
#include <set>
#include <vector>

#include "pliant/improve/sizing.h"

namespace pliant {

/// Refine gives up a triangle where what lies around it refuses every point that would mend it. Where coarsening
/// removes that, refine succeeds; coarsening could then remove what refine has inserted, and so on for ever. This class
/// finds the places where that would begin.
class LeftByRefine {
 public:
  /// A place at which refine would succeed now: the removal of vertices within `reach` of it may have let it.
  struct Awakened {
    Point place;
    double reach;
  };

  /// Complexity  O(triangles)
  LeftByRefine(const Mesh& before, const QualityGoals& goals);
  /// Copies the mesh, which must still be the one that was given first.
  void keep(const Mesh& before) { before_ = before; }
  /// Would refine attack any triangle of `before`?
  bool any() const { return !attacked_.empty(); }
  /// The places where refine would mend a triangle of `after` that it would leave in `before`. It runs on copies of
  /// both meshes to find out.
  ///
  /// Requires    that `before` was kept
  /// Complexity  that of refine on `after`; in the first call also that of refine on `before`
  std::vector<Awakened> awakened_in(const Mesh& after);
  const Mesh& before() const { return before_; }

 private:
  using Corners = std::array<double, 6>;
  static Corners corners_of(const Mesh& mesh, TriangleId t);
  std::set<Corners> triangles_of(const Mesh& mesh, const std::set<Corners>& among) const;
  void find_left();

  const QualityGoals& goals_;
  Mesh before_;
  std::set<Corners> attacked_, left_;
  bool is_known_ = false;    ///< left_ and is_settled_ have been found
  bool is_settled_ = false;  ///< refine would insert nothing in `before`
};

}  // namespace pliant
