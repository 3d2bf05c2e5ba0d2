// lib/pliant/quality/element/element_quality.h: the measures of one element; passes act on these very numbers.
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// D = ∫ det J² dξ / (2 A²): 1 exactly if det J is constant; the mean over the physical element of |J| / 2A.
/// A quadratic form in the coefficients of det J, exact to rounding. NaN if the area is not positive.
/// Paper §5.3.4, in its scale-free meaning (read literally the paper's integral is 1 for every valid element).
double distortion(int degree, std::span<const Point> net);

/// A guaranteed lower bound of min tau(xi) over the element, within 1 % or 1e-6 of it; tau(xi) = 2 det T / ‖T‖²_F with
/// T the Jacobian of the map from the equilateral triangle. Negative if det J is negative somewhere.
double curved_shape(int degree, std::span<const Point> net);

/// tau(xi) at one point.
double shape_at(int degree, std::span<const Point> net, const Barycentric& xi);

/// min det J / max(|min|, |max|), from guaranteed bounds; in [-1, 1]. 0 where det J is zero to rounding everywhere.
double scaled_jacobian(int degree, std::span<const Point> net);

/// Least tau of the p² straight triangles of the control net (paper §5.5).
double control_shape(int degree, std::span<const Point> net);

/// max coefficient of det J over 2 A: how much the largest compression exceeds the mean. NaN if the area is not
/// positive.
double jacobian_peak(int degree, std::span<const Point> net);

/// The largest turning angle of the three edges, in radians.
double element_turning(int degree, std::span<const Point> net);

}  // namespace pliant
