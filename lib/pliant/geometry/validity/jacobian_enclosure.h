// lib/pliant/geometry/validity/jacobian_enclosure.h: det J with a floating-point error bound (private).
#pragma once
#include <array>
#include <span>

#include "pliant/geometry/validity/jacobian_terms.h"

namespace pliant {

inline constexpr double unit_roundoff = 0x1p-53;

/// det J = (coefficients, each within `error`) * 2^exponent; the coefficients are in lattice order.
///
/// Why `error` is a bound: a coefficient is (p^2 / M) times the sum of m_i m_j (a_i.x b_j.y - a_i.y b_j.x) over n pairs
/// of partials; m and M are multinomials with sum m_i m_j = M. With u = 2^-53 every term carries 2 (differences of
/// control points) + 2 (times m) + 1 (product) + 1 (subtraction) + n - 1 (additions) + 2 (weight and its rounding) =
/// n + 7 factors 1 + d, |d| <= u. So the coefficient is wrong by at most gamma(n + 7) p^2 (Ax By + Ay Bx), where Ax is
/// the greatest |a.x| and so on. `error` is (n + 10) u p^2 (Ax By + Ay Bx) as computed, which covers that and the
/// rounding of the bound itself, plus 2^-1000 for what underflows. A power of two scales the differences such that the
/// greatest is within 2^±400, so nothing overflows. Subnormal differences and their integer multiples are exact.
/// Products that are subnormal, and differences that the scaling makes subnormal, lose less than 2^-1030 in all.
struct JacobianEnclosure {
  int degree = 0;          ///< of det J
  int exponent = 0;        ///< of the power of two
  bool is_finite = false;  ///< false if differences overflow; then nothing is known
  double error = 0;        ///< of each coefficient
  double greatest = 0;     ///< max |coefficient|
  std::array<double, max_jacobian_size> coefficients;

  /// The error of coefficients after some bisections: each is a mean of means, at most d roundings deep per bisection.
  double error_at(int depth) const { return error + 2 * depth * degree * unit_roundoff * greatest; }
};

/// Sets `result` to the enclosure of the det J of an element.
void enclose_jacobian(int degree, std::span<const Point> net, JacobianEnclosure& result);

/// Scales the vectors by 2^-e such that their greatest component is about 1, and returns e. Where the greatest
/// component is within 2^±400 already, or 0, the vectors stay and e is 0.
int normalise_differences(std::span<Vector> a, std::span<Vector> b, double greatest);

/// The greatest absolute component; NaN or infinite where differences overflowed.
double greatest_component(std::span<const Vector> a, std::span<const Vector> b);

}  // namespace pliant
