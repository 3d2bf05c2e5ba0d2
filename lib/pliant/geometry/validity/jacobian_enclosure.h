// lib/pliant/geometry/validity/jacobian_enclosure.h: det J with a floating-point error bound (private).
#pragma once
#include <array>
#include <span>

#include "pliant/geometry/validity/jacobian_terms.h"

namespace pliant {

inline constexpr double unit_roundoff = 0x1p-53;

/// det J = (coefficients, each within `error`) * 2^exponent; the coefficients stand in lattice order.
///
/// Bound. A coefficient is (p^2 / M) sum of m_i m_j (a_i.x b_j.y - a_i.y b_j.x) over the n pairs of partials that it
/// takes, m and M multinomials with sum m_i m_j = M. With u = 2^-53 every term carries 2 (differences of control
/// points) + 2 (times m) + 1 (product) + 1 (subtraction) + n - 1 (additions) + 2 (weight and its rounding) = n + 7
/// factors 1 + d, |d| <= u. So the coefficient is wrong by at most gamma(n + 7) p^2 (Ax By + Ay Bx), where Ax is the
/// greatest |a.x| and so on; `error` is (n + 10) u p^2 (Ax By + Ay Bx) as computed, which covers that and the
/// rounding of the bound itself, plus 2^-1000 for what underflows: the differences are scaled by a power of two so that
/// the greatest lies within 2^±400, hence nothing overflows; differences and their integer multiples lose nothing where
/// they are subnormal, and products that do, and differences that the scaling makes so, sum up to less than 2^-1030.
struct JacobianEnclosure {
  int degree = 0;          ///< of det J
  int exponent = 0;        ///< of the power of two
  bool is_finite = false;  ///< false: differences overflow, nothing is known
  double error = 0;        ///< of each coefficient
  double greatest = 0;     ///< max |coefficient|
  std::array<double, max_jacobian_size> coefficients;

  /// The error of coefficients after some bisections: each is a mean of means, at most d roundings deep per bisection.
  double error_at(int depth) const { return error + 2 * depth * degree * unit_roundoff * greatest; }
};

void enclose_jacobian(int degree, std::span<const Point> net, JacobianEnclosure& result);

/// The exponent e such that the greatest component times 2^-e is about 1; 0 where the components are within 2^±400
/// already (or all zero). Scales the vectors.
int normalise_differences(std::span<Vector> a, std::span<Vector> b, double greatest);

/// The greatest absolute component; NaN or infinite where differences overflowed.
double greatest_component(std::span<const Vector> a, std::span<const Vector> b);

}  // namespace pliant
