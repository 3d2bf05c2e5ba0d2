// lib/pliant/improve/refining/left_by_refine.h: triangles that refine has given up, and whether removals let it succeed
// there.
#pragma once
#include <array>
#include <set>
#include <vector>

#include "pliant/improve/sizing.h"

namespace pliant {

/// Refine leaves a triangle where what is around it refuses every point that would mend it. Where coarsening clears
/// that away, refine succeeds, what it inserts can be removed again, and so on for ever.
class LeftByRefine {
 public:
  /// Around a place in which refine would succeed: what was removed this near may have let it.
  struct Awakened {
    Point place;
    double reach;
  };

  /// Complexity   a look at each triangle; a copy of the mesh if refine would attack any
  LeftByRefine(const Mesh& before, const QualityGoals& goals);
  bool any() const { return !attacked_.empty(); }
  /// Where refine would succeed on `after`, and left `before` alone; by running it on copies of both.
  ///
  /// Complexity   refine's, twice; the first time once more
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
  bool is_known_ = false;    ///< left_ and is_settled_ are
  bool is_settled_ = false;  ///< refine inserts nothing in `before`
};

}  // namespace pliant
