#pragma once  // lib/pliant/boundary/box_pairs.h: which of many boxes overlap?
#include <array>
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// Every pair i < j of boxes that overlap or touch, in ascending order.
/// Complexity  O(n log n + pairs) for boxes that do not overlap much more than their neighbours'
std::vector<std::array<int, 2>> overlapping_pairs(std::span<const Box> boxes);

}  // namespace pliant
