// lib/pliant/geometry/validity/validity.cpp: a floating-point filter, floating-point bisection, then exact integers.
#include "pliant/geometry/validity/validity.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>

#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/bisect_net.h"
#include "pliant/geometry/validity/exact_validity.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/geometry/validity/jacobian_enclosure.h"

namespace pliant {
namespace {

/// a x b and the sum of the absolute values of its two products.
struct SignedCross {
  double value, size;
};
inline SignedCross signed_cross(const Vector& a, const Vector& b) {
  const double plus = a.x * b.y;
  const double minus = a.y * b.x;
  return {plus - minus, std::fabs(plus) + std::fabs(minus)};
}

/// Whether a sum of at most two cross products of rounded differences is positive beyond its error. Every product has 2
/// (differences) + 1 (product) + 2 (additions) factors 1 + d, |d| <= u, so the error is at most gamma(5) times the sum
/// of sizes; 6 u of the computed sum covers its rounding too. 2^-1060 is for products that underflow. Overflow gives
/// infinity or NaN, which prove nothing here.
inline bool is_surely_positive(double value, double size) { return value > 6 * unit_roundoff * size + 0x1p-1060; }

/// For p = 2: whether the six coefficients (up to factors) are surely positive, as they are in nearly all elements.
bool is_quadratic_surely_valid(std::span<const Point> net) {
  const Vector a[3] = {net[3] - net[0], net[1] - net[3], net[4] - net[5]};
  const Vector b[3] = {net[5] - net[0], net[4] - net[3], net[2] - net[5]};
  bool result = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const SignedCross at_corner = signed_cross(a[i], b[i]);
    const SignedCross one = signed_cross(a[i], b[j]);
    const SignedCross other = signed_cross(a[j], b[i]);
    result &= is_surely_positive(at_corner.value, at_corner.size);
    result &= is_surely_positive(one.value + other.value, one.size + other.size);
  }
  return result;
}

/// Valid or invalid with proof, or nothing, by depth-first bisection of the enclosure. The first piece that it cannot
/// decide ends it, because the exact search looks at the lowest place first.
std::optional<Validity> certify_by_floating_bisection(const JacobianEnclosure& jacobian) {
  constexpr int greatest_depth = 40;
  constexpr int most_pieces = 4000;
  const int degree = jacobian.degree;
  const std::size_t size = index(net_size(degree));
  const std::array<int, 3> corners = lattice_corners(degree);
  std::array<double, (greatest_depth + 2) * max_jacobian_size> stack;
  std::array<int, greatest_depth + 2> depths;
  std::array<double, max_jacobian_size> piece;
  std::array<double, jacobian_degree(max_degree) + 1> row;
  std::copy_n(jacobian.coefficients.begin(), size, stack.begin());
  depths[0] = 0;
  std::size_t waiting = 1;
  for (int count = 0; waiting > 0; ++count) {
    --waiting;
    const int depth = depths[waiting];
    double* const top = stack.data() + waiting * size;
    const double error = jacobian.error_at(depth);
    double at_corners = HUGE_VAL;
    for (const int c : corners) at_corners = std::min(at_corners, top[c]);
    if (at_corners < -error) return Validity::invalid;
    if (*std::min_element(top, top + size) > error) continue;
    if (at_corners <= error || depth == greatest_depth || count >= most_pieces) return std::nullopt;
    std::copy_n(top, size, piece.begin());
    bisect_net<FloatingMean>(degree, piece.data(), top, top + size, row.data());
    depths[waiting] = depths[waiting + 1] = depth + 1;
    waiting += 2;
  }
  return Validity::valid;
}

Validity certify_slowly(int degree, std::span<const Point> net, int corner) {
  if (degree > 1) {
    JacobianEnclosure jacobian;
    enclose_jacobian(degree, net, jacobian);
    if (jacobian.is_finite) {
      const auto end = jacobian.coefficients.begin() + net_size(jacobian.degree);
      if (*std::min_element(jacobian.coefficients.begin(), end) > jacobian.error) return Validity::valid;
      if (const auto proof = certify_by_floating_bisection(jacobian)) return *proof;
    }
  }
  return certify_exactly(degree, net, corner).validity;
}

}  // namespace

Validity certify(int degree, std::span<const Point> net) {
  assert(1 <= degree && degree <= max_degree && net.size() >= index(net_size(degree)));
  if (degree == 1) {
    const SignedCross area = signed_cross(net[1] - net[0], net[2] - net[0]);
    if (is_surely_positive(area.value, area.size)) return Validity::valid;
    if (is_surely_positive(-area.value, area.size)) return Validity::invalid;
  }
  if (degree == 2 && is_quadratic_surely_valid(net)) return Validity::valid;
  return certify_slowly(degree, net, -1);
}

Validity certify_cusp(int degree, std::span<const Point> net, int corner) {
  assert(0 <= corner && corner < 3 && 1 <= degree && degree <= max_degree && net.size() >= index(net_size(degree)));
  return certify_slowly(degree, net, corner);
}

}  // namespace pliant
