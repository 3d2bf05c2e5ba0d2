// lib/pliant/geometry/validity/validity.h: is det J > 0 on the whole closed element? With proof.
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

enum class Validity { valid, degenerate, invalid };

/// The certificate of one element. *Valid* (min det J > 0 on the closed triangle) and *invalid* (det J < 0 somewhere)
/// are proofs for the doubles as stored, at every degree. *Degenerate* means:
///
///   p <= 2   min det J is exactly 0.
///   p > 2    |min det J| <= 2^-112 c, where c is the greatest |coefficient|
///            of det J; this includes 0.
///
/// (For comparison: a change of one control point in its last place changes det J by some 2^-52 c, or, if J itself is
/// 0, by the square of that.) There is one exception at p > 2. If det J is less than about 2^-20 c along a curve inside
/// the element, 2048 bisections of the lowest piece may not decide. Then *degenerate* means |min det J| <= g c with the
/// gap g reached so far: some 2^-20 for one such curve, and never more than 3 (p - 1)^2 / 2^10.
///
/// Shapes      net: net_size(degree) points, in the order of NetLayout; degree 1..max_degree; all finite
/// Complexity  O(p^4) where the Bernstein coefficients with their floating-point error bound decide (nearly always, and
///             then without allocation); the worst of many hostile inputs: 20 us at p = 2, 25 ms at p = 6
Validity certify(int degree, std::span<const Point> net);

/// The same with one corner (0, 1, 2) forgiven: it is the corner at a cusp, where det J = 0 is allowed, but nowhere
/// else. *Valid* and *invalid* stay proofs (det J > 0 everywhere else; det J < 0 somewhere). *Degenerate* means for
/// p <= 2 that det J is exactly 0 elsewhere too; for p > 2 that bisection cannot decide, for the reasons given above or
/// because the terms of lowest order at the corner vanish in some direction.
Validity certify_cusp(int degree, std::span<const Point> net, int corner);

struct Bounds {
  double lower, upper;
};
/// Guaranteed enclosures of min det J and of max det J, each [lower, upper] no wider than `relative_width` times
/// max |coefficient| of det J (or as narrow as doubles allow).
struct JacobianRange {
  Bounds least, greatest;
};
JacobianRange jacobian_range(int degree, std::span<const Point> net, double relative_width = 1e-3);

}  // namespace pliant
