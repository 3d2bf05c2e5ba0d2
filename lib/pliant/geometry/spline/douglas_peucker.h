// lib/pliant/geometry/spline/douglas_peucker.h: the points that keep a polyline's shape (paper §5.3.3).
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// For each point of the polyline, whether it must stay so that the kept points' polyline is within `tolerance` of it.
/// Closed: the two mutually farthest points (found by two sweeps from point 0) start the recursion.
/// Complexity  O(n log n) typical, O(n^2) worst; iterative (no deep recursion)
std::vector<bool> douglas_peucker(std::span<const Point> polyline, bool closed, double tolerance);

}  // namespace pliant
