// lib/pliant/boundary/box_pairs.h: which of many boxes overlap?
#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// Every pair i < j of boxes that overlap or touch, in ascending order.
/// Complexity  O(n log n + pairs) if most boxes overlap few others
std::vector<std::array<int, 2>> overlapping_pairs(std::span<const Box> boxes);

/// Is given a pair i < j, and returns false if it wants no more.
using PairVisitor = std::function<bool(int i, int j)>;
/// The same pairs, one by one in no particular order, without memory for all of them.
void visit_overlapping_pairs(std::span<const Box> boxes, const PairVisitor& visit);

}  // namespace pliant
