#include "pliant/geometry/validity.h"  // lib/pliant/geometry/validity.cpp: floating-point filter and bisection; the rest is exact_validity

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "pliant/geometry/bisect_net.h"
#include "pliant/geometry/exact_validity.h"
#include "pliant/geometry/jacobian_enclosure.h"

namespace pliant {
namespace {

constexpr std::size_t at(int n) { return static_cast<std::size_t>(n); }

/// a x b and the sum of the absolute values of its two products.
struct SignedCross {
  double value, size;
};
inline SignedCross signed_cross(const Vector& a, const Vector& b) {
  const double plus = a.x * b.y;
  const double minus = a.y * b.x;
  return {plus - minus, std::fabs(plus) + std::fabs(minus)};
}

/// Error of a sum of at most two cross products of rounded differences: 2 (differences) + 1 (product) + 2 (additions)
/// factors 1 + d, |d| <= u, so at most gamma(5) times the sum of sizes; 6 u of the computed sum covers its rounding
/// too. 2^-1060 is for products that underflow. Overflow gives infinity or NaN, which prove nothing here.
inline bool is_surely_positive(double value, double size) { return value > 6 * unit_roundoff * size + 0x1p-1060; }

/// p = 2, nearly always: the six coefficients (up to factors) are positive.
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

/// The error of coefficients after some bisections: each is a mean of means, at most d roundings deep per bisection.
double error_at(const JacobianEnclosure& jacobian, int depth) {
  return jacobian.error + 2 * depth * jacobian.degree * unit_roundoff * jacobian.greatest;
}

/// Valid or invalid with proof, or nothing, by depth-first bisection of the enclosure.
std::optional<Validity> certify_by_floating_point(const JacobianEnclosure& jacobian) {
  constexpr int greatest_depth = 40;
  constexpr int most_pieces = 1000;
  const int degree = jacobian.degree;
  const std::size_t size = at(net_size(degree));
  const std::array<int, 3> corners = lattice_corners(degree);
  std::vector<double> stack(jacobian.coefficients.begin(),
                            jacobian.coefficients.begin() + static_cast<std::ptrdiff_t>(size));
  std::vector<int> depths{0};
  std::vector<double> piece(size);
  std::vector<double> row;
  bool is_open = false;
  for (int count = 0; !depths.empty(); ++count) {
    const int depth = depths.back();
    depths.pop_back();
    std::copy_n(stack.end() - static_cast<std::ptrdiff_t>(size), size, piece.begin());
    const double error = error_at(jacobian, depth);
    double at_corners = HUGE_VAL;
    for (const int c : corners) at_corners = std::min(at_corners, piece[at(c)]);
    if (at_corners < -error) return Validity::invalid;
    const bool is_positive = *std::min_element(piece.begin(), piece.end()) > error;
    if (is_positive || at_corners <= error || depth == greatest_depth || count >= most_pieces) {
      is_open = is_open || !is_positive;
      stack.resize(stack.size() - size);
      continue;
    }
    stack.resize(stack.size() + size);
    bisect_net<FloatingMean>(degree, piece.data(), &stack[stack.size() - 2 * size], &stack[stack.size() - size], row);
    depths.insert(depths.end(), 2, depth + 1);
  }
  if (is_open) return std::nullopt;
  return Validity::valid;
}

Validity certify_slowly(int degree, std::span<const Point> net, int corner) {
  if (degree > 1) {
    JacobianEnclosure jacobian;
    enclose_jacobian(degree, net, jacobian);
    if (jacobian.is_finite)
      if (const auto proof = certify_by_floating_point(jacobian)) return *proof;
  }
  return certify_exactly(degree, net, corner);
}

/// x * 2^exponent, rounded down (towards minus infinity).
double scale_down(double x, int exponent) {
  const double result = std::ldexp(x, exponent);
  const bool is_exact = std::isfinite(result) && std::ldexp(result, -exponent) == x;
  return is_exact ? result : std::nextafter(result, -HUGE_VAL);
}

/// An enclosure of the minimum of `sign` * det J, by bisecting the piece with the least coefficient.
Bounds enclose_minimum(const JacobianEnclosure& jacobian, double sign, double relative_width) {
  struct Piece {
    double least;
    int depth;
    std::vector<double> coefficients;
    bool operator<(const Piece& other) const { return least > other.least; }
  };
  constexpr int greatest_depth = 80;
  constexpr int most_pieces = 20000;
  const int degree = jacobian.degree;
  const std::array<int, 3> corners = lattice_corners(degree);
  double upper = HUGE_VAL;
  std::priority_queue<Piece> pieces;
  const auto add = [&](std::vector<double> coefficients, int depth) {
    const double error = error_at(jacobian, depth);
    for (const int c : corners) upper = std::min(upper, coefficients[at(c)] + error);
    const double least = *std::min_element(coefficients.begin(), coefficients.end()) - error;
    pieces.push({least, depth, std::move(coefficients)});
  };
  std::vector<double> whole;
  for (int n = 0; n < net_size(degree); ++n) whole.push_back(sign * jacobian.coefficients[at(n)]);
  add(std::move(whole), 0);
  std::vector<double> row;
  for (int count = 0; count < most_pieces; ++count) {
    const Piece& worst = pieces.top();
    const double finest = 4 * error_at(jacobian, worst.depth);
    if (upper - worst.least <= std::max(relative_width * jacobian.greatest, finest) || worst.depth == greatest_depth)
      break;
    const int depth = worst.depth + 1;
    std::vector<double> left(worst.coefficients.size());
    std::vector<double> right(worst.coefficients.size());
    bisect_net<FloatingMean>(degree, worst.coefficients.data(), left.data(), right.data(), row);
    pieces.pop();
    add(std::move(left), depth);
    add(std::move(right), depth);
  }
  return {scale_down(pieces.top().least, jacobian.exponent), -scale_down(-upper, jacobian.exponent)};
}

}  // namespace

Validity certify(int degree, std::span<const Point> net) {
  assert(1 <= degree && degree <= max_degree && net.size() >= at(net_size(degree)));
  if (degree == 1) {
    const SignedCross area = signed_cross(net[1] - net[0], net[2] - net[0]);
    if (is_surely_positive(area.value, area.size)) return Validity::valid;
    if (is_surely_positive(-area.value, area.size)) return Validity::invalid;
  }
  if (degree == 2 && is_quadratic_surely_valid(net)) return Validity::valid;
  return certify_slowly(degree, net, -1);
}

Validity certify_cusp(int degree, std::span<const Point> net, int corner) {
  assert(0 <= corner && corner < 3 && 1 <= degree && degree <= max_degree && net.size() >= at(net_size(degree)));
  return certify_slowly(degree, net, corner);
}

JacobianRange jacobian_range(int degree, std::span<const Point> net, double relative_width) {
  assert(1 <= degree && degree <= max_degree && net.size() >= at(net_size(degree)));
  JacobianEnclosure jacobian;
  enclose_jacobian(degree, net, jacobian);
  if (!jacobian.is_finite) return {{-HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, HUGE_VAL}};
  const Bounds least = enclose_minimum(jacobian, 1, relative_width);
  const Bounds negated = enclose_minimum(jacobian, -1, relative_width);
  return {least, {-negated.upper, -negated.lower}};
}

}  // namespace pliant
