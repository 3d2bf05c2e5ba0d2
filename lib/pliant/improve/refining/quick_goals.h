// lib/pliant/improve/refining/quick_goals.h: tells quickly of most triangles that refinement does not attack them.
#pragma once
#include <vector>

#include "pliant/improve/refining/refine_attack.h"

namespace pliant {

/// A quick test for loops over a mesh in which few triangles miss the goals. It has the answers of `attack_on`, which
/// is asked where the quick test does not prove that there is no attack.
class QuickGoals {
 public:
  /// Keeps both references; the mesh may change.
  QuickGoals(const Mesh& mesh, const QualityGoals& goals);

  /// True if attack_on surely finds nothing; false proves nothing. Where true, the
  /// logical triangle is surely not turned over either, and the area of the element is within its bound.
  bool are_surely_met(TriangleId t) const;
  Attack attack_on(TriangleId t) const { return are_surely_met(t) ? Attack{} : pliant::attack_on(mesh_, t, goals_); }

 private:
  bool turns_surely_little(TriangleId t) const;

  const Mesh& mesh_;
  const QualityGoals& goals_;
  std::vector<double> area_bounds_;  // by face
  double squared_sine_ = 0;          // of the least angle, with a margin for rounding
  double least_cosine_ = -1;         // of the angle between two legs of an edge's polygon on a curve
  bool bounds_turning_ = false;
  bool bounds_resolution_ = false;  // of curves: no quick test proves anything of an edge on one
  bool is_known_ = true;            // false where sizes are asked for, which take longer to find
};

}  // namespace pliant
