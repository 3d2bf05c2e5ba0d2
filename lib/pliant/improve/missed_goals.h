// lib/pliant/improve/missed_goals.h: how many elements miss the goals, by reason, and which pass may help.
#pragma once
#include <cstdint>
#include <string>

#include "pliant/improve/sizing.h"

namespace pliant {

/// Elements by the first reason that holds, in this order.
struct MissedGoals {
  std::int64_t invalid = 0;      ///< not certified valid
  std::int64_t turned_over = 0;  ///< the straight triangle is not positive
  std::int64_t too_curved = 0;   ///< for refinement (max_turning), or for smoothing (CurvatureBounds' defaults)
  std::int64_t too_large = 0;    ///< for refinement
  std::int64_t too_poor = 0;     ///< for refinement
};

/// Complexity  O(triangles)
MissedGoals count_missed(const Mesh& mesh, const QualityGoals& goals);

/// For example "3 turned over, 12 too poor"; "no element" where all meet the goals.
std::string describe(const MissedGoals& missed);

/// What would help a mesh of which these are left, in words; empty where nothing is.
std::string advice_on(const MissedGoals& missed);

}  // namespace pliant
