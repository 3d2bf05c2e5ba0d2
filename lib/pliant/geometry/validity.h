#pragma once  // lib/pliant/geometry/validity.h: is det J > 0 on the whole closed element? A proof (design: validity)
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

enum class Validity { valid, degenerate, invalid };

/// The certificate of one element: *valid* (min det J > 0 on the closed triangle) and *invalid* (< 0 somewhere) are
/// proofs for the doubles as stored; *degenerate* is min = 0 exactly for p <= 2, and for p > 2 also what exact
/// subdivision to depth 30 cannot separate from zero.
///
/// Shapes      net: net_size(degree) points, in the order of NetLayout; degree 1..max_degree; all finite
/// Complexity  O(p^4) where the Bernstein coefficients with their floating-point error bound decide (nearly always)
Validity certify(int degree, std::span<const Point> net);

/// The same with one corner (0, 1, 2) forgiven: a cusp's corner, where det J = 0 is allowed at that corner alone.
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
