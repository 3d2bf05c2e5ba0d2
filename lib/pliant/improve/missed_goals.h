// lib/pliant/improve/missed_goals.h: counts the elements that miss the goals, by reason, and names the pass that may
// help.
#pragma once
#include <cstdint>
#include <string>

#include "pliant/improve/sizing.h"

namespace pliant {

/// How many elements miss the goals. Each is counted once, under the first of these reasons that holds for it.
struct MissedGoals {
  std::int64_t invalid = 0;      ///< not certified valid
  std::int64_t turned_over = 0;  ///< the logical triangle is turned over or flat
  std::int64_t too_curved =
      0;  ///< by refinement's bound (max_turning), or by smoothing's (the defaults of CurvatureBounds)
  std::int64_t too_large = 0;  ///< by refinement's bounds
  std::int64_t too_poor = 0;   ///< by refinement's bound on angles
};

/// Complexity  O(triangles)
MissedGoals count_missed(const Mesh& mesh, const QualityGoals& goals);

/// The counts in words, for example "3 turned over, 12 too poor"; "no element" where all meet the goals.
std::string describe(const MissedGoals& missed);

/// Which pass would help a mesh that has these elements left, in words; empty where there are none.
std::string advice_on(const MissedGoals& missed);

}  // namespace pliant
