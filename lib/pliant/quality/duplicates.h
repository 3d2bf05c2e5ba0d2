// lib/pliant/quality/duplicates.h: points at one place (private to this layer).
#pragma once
#include <cstdint>
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// How many of the points with use[i] == wanted are at the very place of an earlier one (0.0 and -0.0 are one place).
/// Complexity  O(points), by hashing
std::int64_t count_duplicates(std::span<const Point> points, std::span<const char> use, char wanted);

}  // namespace pliant
