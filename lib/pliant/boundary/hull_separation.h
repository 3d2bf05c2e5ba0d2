// lib/pliant/boundary/hull_separation.h: are two control polygons' convex hulls apart?
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// True if a line normal to a leg or chord of either polygon, or to an axis, separates the two hulls by more than
/// `margin` (length). For hulls of at most three points this finds every separation.
bool hulls_apart(std::span<const Point> a, std::span<const Point> b, double margin);

/// For polygons that start in the same point: true if a line through it separates all the others of `a` from all the
/// others of `b`, strictly, as an angle above `margin` (radians). The curves then meet in that point only.
bool cones_apart(std::span<const Point> a, std::span<const Point> b, double margin);

/// The hull's height over the chord: the greatest distance of a control point from the line through the ends.
double hull_height(std::span<const Point> polygon);

}  // namespace pliant
