#pragma once  // lib/pliant/geometry/exact_validity.h: the certificate in exact arithmetic (private to this layer)
#include <span>

#include "pliant/geometry/validity.h"

namespace pliant {

/// What certify (corner = -1) and certify_cusp promise, in exact integers: the control points are scaled by a power of
/// two to integers of any length, so nothing is rounded, overflows or underflows. For p <= 2 the sign of the minimum
/// itself; for p > 2 by bisection, to pieces of 2^-30 of the element or to a fixed number of pieces.
Validity certify_exactly(int degree, std::span<const Point> net, int corner);

}  // namespace pliant
