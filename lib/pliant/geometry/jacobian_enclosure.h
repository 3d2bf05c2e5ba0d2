#pragma once  // lib/pliant/geometry/jacobian_enclosure.h: det J with a floating-point error bound (private)
#include <array>
#include <span>

#include "pliant/geometry/jacobian_terms.h"

namespace pliant {

inline constexpr double unit_roundoff = 0x1p-53;

/// det J = (coefficients, each within `error`) * 2^exponent; the coefficients stand in lattice order.
///
/// Bound. With u = 2^-53 every difference of control points is the true one times (1 + d), |d| <= u; each product of
/// the sum sum_n w (a b - c e) then carries at most 2 (differences) + 1 (product) + 1 (subtraction) + 2 (weight and its
/// rounding) + n - 1 (additions) = n + 5 such factors. So a coefficient is wrong by at most
/// gamma(n + 5) * S, S = sum w (|a b| + |c e|), and (n + 8) u S, with S as computed, covers that and its own rounding.
/// `error` is the greatest of these plus 2^-1000, for products that underflow: the differences are scaled by a power of
/// two so that the greatest lies within 2^±400, hence nothing overflows, and what underflows is below 2^-1040 in sum.
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
