// lib/pliant/geometry/validity/jacobian_range.cpp: enclosures of the extrema of det J.
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>

#include "pliant/geometry/index.h"
#include "pliant/geometry/lattice.h"
#include "pliant/geometry/validity/bernstein_range.h"
#include "pliant/geometry/validity/jacobian_enclosure.h"
#include "pliant/geometry/validity/validity.h"

namespace pliant {
namespace {

/// x * 2^exponent, rounded down (towards minus infinity).
double scale_down(double x, int exponent) {
  const double result = std::ldexp(x, exponent);
  const bool is_exact = std::isfinite(result) && std::ldexp(result, -exponent) == x;
  return is_exact ? result : std::nextafter(result, -HUGE_VAL);
}
Bounds scale(const Bounds& bounds, int exponent) {
  return {scale_down(bounds.lower, exponent), -scale_down(-bounds.upper, exponent)};
}

}  // namespace

JacobianRange jacobian_range(int degree, std::span<const Point> net, double relative_width) {
  assert(1 <= degree && degree <= max_degree && net.size() >= index(net_size(degree)));
  JacobianEnclosure jacobian;
  enclose_jacobian(degree, net, jacobian);
  if (!jacobian.is_finite) return {{-HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, HUGE_VAL}};
  std::array<double, max_jacobian_size> storage;
  const std::span<double> coefficients = std::span(storage).first(index(net_size(jacobian.degree)));
  const std::vector<int>& order = lattice_order(jacobian.degree);
  for (std::size_t n = 0; n < coefficients.size(); ++n) coefficients[n] = jacobian.coefficients[index(order[n])];
  const double width = relative_width * jacobian.greatest;
  return {scale(enclose_minimum(jacobian.degree, coefficients, jacobian.error, width), jacobian.exponent),
          scale(enclose_maximum(jacobian.degree, coefficients, jacobian.error, width), jacobian.exponent)};
}

}  // namespace pliant
