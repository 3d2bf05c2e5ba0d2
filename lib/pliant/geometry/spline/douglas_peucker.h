// lib/pliant/geometry/spline/douglas_peucker.h: the points that keep a polyline's shape (paper §5.3.3).
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// For each point of a polyline, whether it is kept, such that every other point is within `tolerance` of the polyline
/// of the kept ones. The ends of an open polyline are kept. On a closed one, the point farthest from point 0 and the
/// point farthest from that are kept.
///
/// Complexity  O(n log n) typical, O(n^2) worst; iterative (no deep recursion)
std::vector<bool> douglas_peucker(std::span<const Point> polyline, bool closed, double tolerance);

}  // namespace pliant
