// lib/pliant/boundary/arrangement/arrangement_input.h: curves that do not stop, fold back on a line or turn in no room.
#pragma once
#include <vector>

#include "pliant/geometry/spline/bspline.h"

namespace pliant {

/// The same way, run through without stopping: spans that stay at a point are left out, and straight ones on which the
/// derivative vanishes or changes its direction become segments run through evenly. Tips, which turn by more than 60
/// degrees within the length `tip`, become corners: no mesh could follow them. The curve itself, bit for bit, if it has
/// none of these; otherwise open curves, in order, each starting where the one before it ends (to rounding); none where
/// nothing is left.
std::vector<BSpline> split_at_stops(const BSpline& spline, double tip = 0);

}  // namespace pliant
