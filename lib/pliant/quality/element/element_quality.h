// lib/pliant/quality/element/element_quality.h: the measures of one element, for reports and for passes alike.
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// The distortion D = ∫ det J² dξ / (2 A²), with A the area: the mean of det J / 2A over the physical element, 1 if det
/// J is constant. It is a quadratic form in the coefficients of det J, exact to rounding. NaN if the area is not
/// positive.
///
/// Paper       §5.3.4, whose integral, read literally, is 1 for every valid element; D is its scale-free meaning
double distortion(int degree, std::span<const Point> net);

/// The curved shape: a guaranteed lower bound of min tau(xi) over the element, at most 1 % or 1e-6 below it. Here
/// tau(xi) = 2 det T / ‖T‖²_F, and T is the Jacobian of the map from the equilateral triangle. Negative if det J is
/// negative somewhere.
double curved_shape(int degree, std::span<const Point> net);

/// tau(xi) at one point.
double shape_at(int degree, std::span<const Point> net, const Barycentric& xi);

/// The scaled Jacobian min / max(|min|, |max|) of det J over the element, from guaranteed bounds; in [-1, 1]. 0 if det
/// J is zero to rounding everywhere.
double scaled_jacobian(int degree, std::span<const Point> net);

/// The least tau of the p² straight triangles of the control net (paper §5.5).
double control_shape(int degree, std::span<const Point> net);

/// The largest coefficient of det J divided by its mean, 2 A. NaN if the area is not positive.
double jacobian_peak(int degree, std::span<const Point> net);

/// The largest turning angle of the three edges, in radians.
double element_turning(int degree, std::span<const Point> net);

}  // namespace pliant
