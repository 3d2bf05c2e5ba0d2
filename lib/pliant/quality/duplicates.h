// lib/pliant/quality/duplicates.h: counts points at the same place (private to this layer).
#pragma once
#include <cstdint>
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// How many of the points with use[i] == wanted are exactly where an earlier one of them is (0.0 and -0.0 are the
/// same).
///
/// Complexity  O(points), by hashing
std::int64_t count_duplicates(std::span<const Point> points, std::span<const char> use, char wanted);

}  // namespace pliant
