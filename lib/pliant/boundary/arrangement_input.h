#pragma once  // lib/pliant/boundary/arrangement_input.h: curves without spans that stop or fold back on a line
#include <vector>

#include "pliant/geometry/bspline.h"

namespace pliant {

/// The same way, run through without stopping: spans that stay at a point are left out, and straight ones on which the
/// derivative vanishes or changes its direction become segments run through evenly. The curve itself, bit for bit, if
/// it has none of these; otherwise open curves, in order, each starting where the one before it ends (to rounding).
std::vector<BSpline> split_at_stops(const BSpline& spline);

}  // namespace pliant
