// lib/pliant/geometry/validity/exact_validity.cpp: signs of integers, never rounded.
#include "pliant/geometry/validity/exact_validity.h"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/exact_bisection.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/geometry/validity/jacobian_terms.h"

namespace pliant {
namespace {

using Integer = boost::multiprecision::cpp_int;

struct IntegerVector {
  Integer x, y;
};
Integer cross(const IntegerVector& a, const IntegerVector& b) { return a.x * b.y - a.y * b.x; }

/// A double as an odd integer times 2^exponent; 0 is mantissa 0 with exponent 0.
struct OddInteger {
  std::int64_t mantissa = 0;
  int exponent = 0;
  explicit OddInteger(double x) {
    if (x == 0) return;
    mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    mantissa >>= zeros;
    exponent += zeros - 53;
  }
};

/// One coordinate of all points, times the power of two that makes integers of them. x and y may have different powers,
/// because these only scale det J.
template <class Coordinate>
std::vector<Integer> scaled(std::span<const Point> net, Coordinate coordinate) {
  int least = 2000;
  for (const Point& p : net)
    if (const OddInteger x(coordinate(p)); x.mantissa != 0) least = std::min(least, x.exponent);
  std::vector<Integer> result;
  for (const Point& p : net) {
    const OddInteger x(coordinate(p));
    result.emplace_back(x.mantissa);
    if (x.mantissa != 0) result.back() <<= x.exponent - least;
  }
  return result;
}

struct Partials {
  std::vector<IntegerVector> along_2, along_3;
};

Partials exact_partials(const JacobianTerms& terms, std::span<const Point> net) {
  const std::span<const Point> points = net.first(index(net_size(terms.degree)));
  const std::vector<Integer> x = scaled(points, [](const Point& p) { return p.x; });
  const std::vector<Integer> y = scaled(points, [](const Point& p) { return p.y; });
  Partials result;
  for (const auto& [first, second, third] : terms.partials) {
    const std::size_t from = index(first);
    result.along_2.push_back({x[index(second)] - x[from], y[index(second)] - y[from]});
    result.along_3.push_back({x[index(third)] - x[from], y[index(third)] - y[from]});
  }
  return result;
}

Certificate from_sign(int sign) {
  return {sign > 0 ? Validity::valid : sign < 0 ? Validity::invalid : Validity::degenerate, 0};
}

/// det J of an element with p = 2 is a quadratic form xi^T B xi, so its minimum over the triangle is positive exactly
/// if B is strictly copositive. B is given by its diagonal and, as `mixed`, its entries 01, 12, 20.
struct QuadraticForm {
  std::array<Integer, 3> diagonal, mixed;

  /// Sign of the minimum over the closed edge (e, e + 1). The minimum is at an end, or inside if the form falls from
  /// both ends.
  int sign_on_edge(std::size_t e) const {
    const Integer& a = diagonal[e];
    const Integer& b = diagonal[(e + 1) % 3];
    const int at_ends = std::min(a.sign(), b.sign());
    if (at_ends < 0 || mixed[e].sign() >= 0) return at_ends;
    const Integer determinant = a * b - mixed[e] * mixed[e];
    return std::min(at_ends, determinant.sign());
  }

  /// Sign of the minimum over the closed triangle. If the minimum is in the interior, it is where B xi = lambda
  /// (1, 1, 1), so xi = w / s with w = adj(B) (1, 1, 1), s = sum w, and the value is lambda = det B / s. (If w vanishes
  /// or leaves the triangle, the least value is also taken on an edge.)
  int sign_of_minimum() const {
    int sign = 1;
    for (std::size_t e = 0; e < 3; ++e) sign = std::min(sign, sign_on_edge(e));
    if (sign < 0) return sign;
    const auto& [a, b, c] = diagonal;
    const auto& [f, g, h] = mixed;  // entries 01, 12, 20
    const Integer cofactor_a = b * c - g * g;
    const Integer cofactor_f = g * h - f * c;
    const Integer cofactor_h = f * g - b * h;
    const Integer w0 = cofactor_a + cofactor_f + cofactor_h;
    const Integer w1 = cofactor_f + (a * c - h * h) + (h * f - a * g);
    const Integer w2 = cofactor_h + (h * f - a * g) + (a * b - f * f);
    if (w0.sign() <= 0 || w1.sign() <= 0 || w2.sign() <= 0) return sign;
    const Integer determinant = a * cofactor_a + f * cofactor_f + h * cofactor_h;
    return std::min(sign, determinant.sign());
  }

  /// Sign of the minimum over the triangle without one corner, where the form is 0. On the way from that corner (t = 0)
  /// to a point a of the opposite edge (t = 1) the form is t (2 (1 - t) L(a) + t Q(a)), where L is linear with the two
  /// mixed entries of the corner, and Q is the form on the edge.
  int sign_without_corner(std::size_t corner) const {
    if (mixed[corner].sign() < 0 || mixed[(corner + 2) % 3].sign() < 0) return -1;
    return sign_on_edge((corner + 1) % 3);
  }
};

Certificate certify_quadratic(const Partials& partials, int corner) {
  const auto& a = partials.along_2;
  const auto& b = partials.along_3;
  QuadraticForm form;  // det J / 2, which has integer entries
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    form.diagonal[i] = 2 * cross(a[i], b[i]);
    form.mixed[i] = cross(a[i], b[j]) + cross(a[j], b[i]);
  }
  if (corner >= 0 && form.diagonal[index(corner)].is_zero()) return from_sign(form.sign_without_corner(index(corner)));
  return from_sign(form.sign_of_minimum());
}

/// d! times the Bernstein coefficients of det J / p^2, where d is the degree of det J. These are integers, because the
/// multinomials divide d!.
std::vector<Integer> exact_coefficients(const JacobianTerms& terms, const Partials& partials) {
  const NetLayout& layout = NetLayout::of(jacobian_degree(terms.degree));
  std::vector<Integer> sums(index(layout.size()));
  for (const JacobianTerm& term : terms.terms) {
    const Integer product = cross(partials.along_2[index(term.i)], partials.along_3[index(term.j)]);
    sums[index(term.target)] += static_cast<std::int64_t>(term.integer_product) * product;
  }
  std::vector<Integer> result(sums.size());
  const std::vector<int>& order = lattice_order(layout.degree());
  for (int n = 0; n < layout.size(); ++n) {
    std::int64_t factor = 1;
    for (const int exponent : layout.exponents(n))
      for (int m = 2; m <= exponent; ++m) factor *= m;
    result[index(order[index(n)])] = sums[index(n)] * factor;
  }
  return result;
}

/// The same numbers as limbs, in two's complement.
LimbNet to_limbs(int degree, const std::vector<Integer>& coefficients, int bits) {
  LimbNet net(degree, index(bits / 64 + 1));
  for (int n = 0; n < net.size(); ++n) {
    const Integer& x = coefficients[index(n)];
    Limb* const to = net.at(n);
    if (x.is_zero()) continue;
    // -x = ~(x - 1), and x - 1 is not negative.
    export_bits(x.sign() > 0 ? x : Integer(-x - 1), to, 64, false);
    if (x.sign() < 0) std::transform(to, to + net.width(), to, [](Limb limb) { return ~limb; });
  }
  return net;
}

}  // namespace

Certificate certify_exactly(int degree, std::span<const Point> net, int corner) {
  const JacobianTerms& terms = JacobianTerms::of(degree);
  const Partials partials = exact_partials(terms, net);
  if (degree == 1) return from_sign(cross(partials.along_2[0], partials.along_3[0]).sign());
  if (degree == 2) return certify_quadratic(partials, corner);
  const std::vector<Integer> coefficients = exact_coefficients(terms, partials);
  int bits = 0;
  for (const Integer& x : coefficients)
    if (!x.is_zero()) bits = std::max(bits, static_cast<int>(msb(abs(x))) + 1);
  if (bits == 0) return {Validity::degenerate, 0};
  return certify_by_bisection(to_limbs(jacobian_degree(degree), coefficients, bits), bits, corner);
}

}  // namespace pliant
