// lib/pliant/geometry/validity/swept_validity.h: validity during a straight motion of the control points.
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// The largest proved fraction f in [0, 1] such that the element with control points (1 - t) from + t to is valid for
/// all t in [0, f]. 1 means the whole motion is proved. Conservative: within 1e-3 of the true fraction or below
/// (f = 0 if `from` itself is not valid).
///
/// det J(xi, t) is a polynomial of degree 2(p - 1) in xi and 2 in t. Its tensor Bernstein form, with a floating-point
/// error bound, proves that it is positive in a time interval; an interval where this fails is halved.
///
/// `cusp` is a corner (0, 1, 2) where det J is 0 because the boundary has a cusp there, or -1. During the motion its
/// two tangents are parallel only up to rounding, so within 2^-10 of the element's size around that corner nothing is
/// proved. After the step certify_cusp decides.
double safe_fraction(int degree, std::span<const Point> from, std::span<const Point> to, int cusp = -1);

}  // namespace pliant
