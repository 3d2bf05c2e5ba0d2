// lib/pliant/geometry/predicates.h: exact signs of orientation and in-circle determinants.
#pragma once
#include "pliant/geometry/point.h"

namespace pliant {

/// Sign (-1, 0, 1) of twice the signed area of a, b, c: 1 if they turn counter-clockwise. Exact for all finite
/// doubles (underflow and overflow of intermediate products included: inputs are scaled in the exact stage).
int orient2d(const Point& a, const Point& b, const Point& c);

/// 1 if d lies inside the circle through a, b, c (counter-clockwise), -1 outside, 0 on it. Exact as above.
int in_circle(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace pliant
