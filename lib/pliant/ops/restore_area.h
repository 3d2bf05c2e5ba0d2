#pragma once  // lib/pliant/ops/restore_area.h: a curve that lost a knot, made to sweep the area that it did
#include "pliant/geometry/bspline.h"

namespace pliant {

/// Moves the control points around the removed break `knot` of `spline` so that the area swept by the curve is that of
/// `old`. Returns a bound of the distance between the two curves then; infinite, `spline` of no use, where too much is
/// missing for small steps.
double restore_area(const BSpline& old, BSpline& spline, double knot);

}  // namespace pliant
