// lib/pliant/boundary/hull_separation.h: are two control polygons' convex hulls apart?
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// True if the two hulls are more than `margin` (a length) apart across a line that is parallel to an axis, to a leg or
/// to the chord of either polygon, or normal to a chord. For hulls of at most three points this finds every separation.
bool hulls_apart(std::span<const Point> a, std::span<const Point> b, double margin);

/// For polygons that start in the same point: true if a line through that point separates the other points of `a` from
/// those of `b`, and the angle between the line and the way to any of them is above `margin` (radians). The curves then
/// meet in that point only.
bool cones_apart(std::span<const Point> a, std::span<const Point> b, double margin);

/// The hull's height over the chord: the greatest distance of a control point from the line through the ends.
double hull_height(std::span<const Point> polygon);

}  // namespace pliant
