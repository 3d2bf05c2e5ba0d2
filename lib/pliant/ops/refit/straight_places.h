// lib/pliant/ops/refit/straight_places.h: places in straight triangles, and numbers of free points (private to ops).
#pragma once
#include <algorithm>
#include <span>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"
#include "pliant/mesh/ids.h"

namespace pliant {

/// The place of control point k in the straight triangle a, b, c.
inline Point straight(const NetLayout& layout, int k, const Point& a, const Point& b, const Point& c) {
  const int j = layout.exponents(k)[1], l = layout.exponents(k)[2];
  return a + (1.0 / layout.degree()) * (j * (b - a) + l * (c - a));
}

/// The number of a point among the free ones; -1 if it is none of them.
inline int index_in(std::span<const PointId> free, PointId p) {
  const auto found = std::find(free.begin(), free.end(), p);
  return found == free.end() ? -1 : static_cast<int>(found - free.begin());
}

}  // namespace pliant
