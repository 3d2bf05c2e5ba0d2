// lib/pliant/geometry/spline/restore_area.h: a closed curve offset until it encloses the area wanted.
#pragma once
#include "pliant/geometry/spline/bspline.h"

namespace pliant {

/// Moves each point of a closed curve along its normal by one length, so that the curve encloses `area` (to rounding).
/// The offset is interpolated at the Greville abscissae, and the knots stay.
///
/// Units       area: signed, positive for a curve that runs counter-clockwise
/// Ensures     the curve is bit for bit as it was where no offset brings it closer to the area
/// Returns     the offset, a length; 0 where none was taken
/// Complexity  O(control points * degree^2)
double restore_area(BSpline& spline, double area);

}  // namespace pliant
