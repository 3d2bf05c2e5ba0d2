#include "pliant/geometry/exact_validity.h"  // lib/pliant/geometry/exact_validity.cpp: signs of integers, never rounded

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "pliant/geometry/bisect_net.h"
#include "pliant/geometry/jacobian.h"
#include "pliant/geometry/jacobian_terms.h"

namespace pliant {
namespace {

using Integer = boost::multiprecision::cpp_int;
constexpr std::size_t at(int n) { return static_cast<std::size_t>(n); }

struct IntegerVector {
  Integer x, y;
};
Integer cross(const IntegerVector& a, const IntegerVector& b) { return a.x * b.y - a.y * b.x; }

/// The exponent of the lowest bit of a double's 53-bit mantissa; the mantissa as an integer.
std::pair<std::int64_t, int> mantissa_and_exponent(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

Integer scaled(double x, int least_exponent) {
  const auto [mantissa, exponent] = mantissa_and_exponent(x);
  Integer result = mantissa;
  if (mantissa != 0) result <<= exponent - least_exponent;
  return result;
}

struct Partials {
  std::vector<IntegerVector> along_2, along_3;
};

Partials exact_partials(const JacobianTerms& terms, std::span<const Point> net) {
  int least = 2000;
  for (const Point& p : net.first(at(net_size(terms.degree))))
    for (const double x : {p.x, p.y})
      if (x != 0) least = std::min(least, mantissa_and_exponent(x).second);
  std::vector<IntegerVector> points;
  for (const Point& p : net.first(at(net_size(terms.degree))))
    points.push_back({scaled(p.x, least), scaled(p.y, least)});
  Partials result;
  for (const auto& [first, second, third] : terms.partials) {
    const IntegerVector& from = points[at(first)];
    result.along_2.push_back({points[at(second)].x - from.x, points[at(second)].y - from.y});
    result.along_3.push_back({points[at(third)].x - from.x, points[at(third)].y - from.y});
  }
  return result;
}

Validity from_sign(int sign) {
  return sign > 0 ? Validity::valid : sign < 0 ? Validity::invalid : Validity::degenerate;
}

/// det J of p = 2 is the quadratic form xi^T B xi, so its minimum over the triangle is positive exactly where B is
/// strictly copositive. B as its diagonal and its entries 01, 12, 20.
struct QuadraticForm {
  std::array<Integer, 3> diagonal, mixed;

  /// Sign of the minimum over the closed edge (e, e + 1): at an end, or, where the form falls from both ends, inside.
  int sign_on_edge(std::size_t e) const {
    const Integer& a = diagonal[e];
    const Integer& b = diagonal[(e + 1) % 3];
    const int at_ends = std::min(a.sign(), b.sign());
    if (at_ends < 0 || mixed[e].sign() >= 0) return at_ends;
    const Integer determinant = a * b - mixed[e] * mixed[e];
    return std::min(at_ends, determinant.sign());
  }

  /// Sign of the minimum over the closed triangle. In the interior it is where B xi = lambda (1, 1, 1), so
  /// xi = w / s with w = adj(B) (1, 1, 1), s = sum w, and the value is lambda = det B / s. (Where w vanishes or leaves
  /// the triangle, the least value is also taken on an edge.)
  int sign_of_minimum() const {
    int sign = 1;
    for (std::size_t e = 0; e < 3; ++e) sign = std::min(sign, sign_on_edge(e));
    if (sign < 0) return sign;
    const auto& [a, b, c] = diagonal;
    const auto& [f, g, h] = mixed;  // entries 01, 12, 20
    const Integer of_a = b * c - g * g;
    const Integer of_f = g * h - f * c;
    const Integer of_h = f * g - b * h;
    const Integer w0 = of_a + of_f + of_h;
    const Integer w1 = of_f + (a * c - h * h) + (h * f - a * g);
    const Integer w2 = of_h + (h * f - a * g) + (a * b - f * f);
    if (w0.sign() <= 0 || w1.sign() <= 0 || w2.sign() <= 0) return sign;
    const Integer determinant = a * of_a + f * of_f + h * of_h;
    return std::min(sign, determinant.sign());
  }

  /// The same on the triangle without a corner where the form is 0. On the ray from there to a point a of the opposite
  /// edge it is t (2 (1 - t) L(a) + t Q(a)), L linear with the two mixed entries, Q the form on the edge.
  int sign_without_corner(std::size_t corner) const {
    if (mixed[corner].sign() < 0 || mixed[(corner + 2) % 3].sign() < 0) return -1;
    return sign_on_edge((corner + 1) % 3);
  }
};

Validity certify_quadratic(const Partials& partials, int corner) {
  const auto& a = partials.along_2;
  const auto& b = partials.along_3;
  QuadraticForm form;  // 2 det J / 4
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    form.diagonal[i] = 2 * cross(a[i], b[i]);
    form.mixed[i] = cross(a[i], b[j]) + cross(a[j], b[i]);
  }
  if (corner >= 0 && form.diagonal[at(corner)].is_zero()) return from_sign(form.sign_without_corner(at(corner)));
  return from_sign(form.sign_of_minimum());
}

struct Piece {
  std::vector<Integer> coefficients;  // in lattice order
  int corner;                         // the forgiven one, if the piece has it
  int depth;
};

enum class Claim { positive, touches_zero, negative, open };

/// What the signs of the coefficients prove. Non-negative ones and three positive corners suffice for det J > 0:
/// everywhere some corner's basis function is positive. With two, it is so everywhere but in the third corner.
Claim claim_of(int degree, const Piece& piece) {
  bool corners_positive = true;
  const std::array<int, 3> corners = lattice_corners(degree);
  for (int c = 0; c < 3; ++c) {
    const int sign = piece.coefficients[at(corners[at(c)])].sign();
    if (sign < 0) return Claim::negative;
    if (sign == 0 && c != piece.corner) corners_positive = false;
  }
  bool any_positive = false;
  bool any_negative = false;
  for (const Integer& x : piece.coefficients) {
    any_positive = any_positive || x.sign() > 0;
    any_negative = any_negative || x.sign() < 0;
  }
  if (!any_negative) return corners_positive ? Claim::positive : Claim::touches_zero;
  return any_positive ? Claim::open : Claim::negative;
}

struct ExactMean {
  static void add(Integer& a, const Integer& b) { a += b; }
  static void align(Integer& a, int halvings) { a <<= halvings; }
};

/// d! times the Bernstein coefficients of det J / p^2, an integer each: the multinomials divide d!.
std::vector<Integer> exact_coefficients(const JacobianTerms& terms, const Partials& partials) {
  const NetLayout& layout = NetLayout::of(jacobian_degree(terms.degree));
  std::vector<Integer> sums(at(layout.size()));
  for (const JacobianTerm& term : terms.terms) {
    const Integer product = cross(partials.along_2[at(term.i)], partials.along_3[at(term.j)]);
    sums[at(term.target)] += static_cast<std::int64_t>(term.integer_product) * product;
  }
  std::vector<Integer> result(sums.size());
  const std::vector<int>& order = lattice_order(layout.degree());
  for (int n = 0; n < layout.size(); ++n) {
    std::int64_t factor = 1;
    for (const int exponent : layout.exponents(n))
      for (int m = 2; m <= exponent; ++m) factor *= m;
    result[at(order[at(n)])] = sums[at(n)] * factor;
  }
  return result;
}

Validity certify_by_bisection(int degree, std::vector<Integer> coefficients, int corner) {
  constexpr int greatest_depth = 60;  // two bisections halve the diameter
  constexpr int most_pieces = 8192;
  constexpr std::size_t most_waiting = 1024;
  bool is_separated = true;  // from zero
  std::deque<Piece> waiting;
  waiting.push_back({std::move(coefficients), corner, 0});
  std::vector<Integer> row;
  for (int count = 0; !waiting.empty(); ++count) {
    Piece piece = std::move(waiting.front());
    waiting.pop_front();
    const Claim claim = claim_of(degree, piece);
    if (claim == Claim::negative) return Validity::invalid;
    if (claim == Claim::positive) continue;
    if (claim == Claim::touches_zero || piece.depth == greatest_depth || count >= most_pieces ||
        waiting.size() >= most_waiting) {
      is_separated = false;  // the others are still asked whether they are negative
      continue;
    }
    Piece left{std::vector<Integer>(piece.coefficients.size()), corner_in_left(piece.corner), piece.depth + 1};
    Piece right{std::vector<Integer>(piece.coefficients.size()), corner_in_right(piece.corner), piece.depth + 1};
    bisect_net<ExactMean>(degree, piece.coefficients.data(), left.coefficients.data(), right.coefficients.data(), row);
    waiting.push_back(std::move(left));
    waiting.push_back(std::move(right));
  }
  return is_separated ? Validity::valid : Validity::degenerate;
}

}  // namespace

Validity certify_exactly(int degree, std::span<const Point> net, int corner) {
  const JacobianTerms& terms = JacobianTerms::of(degree);
  const Partials partials = exact_partials(terms, net);
  if (degree == 1) return from_sign(cross(partials.along_2[0], partials.along_3[0]).sign());
  if (degree == 2) return certify_quadratic(partials, corner);
  return certify_by_bisection(jacobian_degree(degree), exact_coefficients(terms, partials), corner);
}

}  // namespace pliant
