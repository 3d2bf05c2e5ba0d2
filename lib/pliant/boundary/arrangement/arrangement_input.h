// lib/pliant/boundary/arrangement/arrangement_input.h: curves without places where they stop, fold back or have a tip.
#pragma once
#include <vector>

#include "pliant/geometry/spline/bspline.h"

namespace pliant {

/// The same curve, in parts that do not stop. Spans that stay at one point are left out. Straight spans on which the
/// derivative vanishes or changes its direction become segments of constant speed. Tips become corners: these are
/// places where the curve turns by more than 60 degrees within the length `tip`, which no mesh could follow.
///
/// Returns     the curve itself, bit for bit, if it has none of these; otherwise open curves in order, each of which
///             starts where the one before it ends (to rounding); nothing if nothing is left
std::vector<BSpline> split_at_stops(const BSpline& spline, double tip = 0);

}  // namespace pliant
