// tests/support/exact_jacobian.h: the least det J of an element, exactly; shares no code with the library.
#pragma once
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <vector>

#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/point.h"
#include "pliant/geometry/validity/validity.h"

namespace pliant::samples {

using Rational = boost::multiprecision::cpp_rational;
using Integer = boost::multiprecision::int256_t;

enum class Place { corner, edge, face };
struct Minimum {
  Rational value;
  Place place = Place::corner;
  void lower(const Rational& candidate, Place where) {
    if (candidate < value) value = candidate, place = where;
  }
};

/// The exact minimum of det J of a quadratic element, by calculus on its power form
/// q(x, y) = q0 + q1 x + q2 y + q3 x^2 + q4 x y + q5 y^2, x = xi2, y = xi3.
inline Minimum exact_minimum(const std::vector<Point>& net) {
  // chi = a0 + a1 x + a2 y + a3 x^2 + a4 x y + a5 y^2
  Rational a[6][2];
  for (int c = 0; c < 2; ++c) {
    const auto b = [&](std::size_t n) { return Rational(c == 0 ? net[n].x : net[n].y); };
    a[0][c] = b(0);
    a[1][c] = 2 * (b(3) - b(0));
    a[2][c] = 2 * (b(5) - b(0));
    a[3][c] = b(0) - 2 * b(3) + b(1);
    a[4][c] = 2 * (b(0) - b(3) - b(5) + b(4));
    a[5][c] = b(0) - 2 * b(5) + b(2);
  }
  const auto det = [&](int m, int n) -> Rational { return a[m][0] * a[n][1] - a[m][1] * a[n][0]; };
  // (a1 + 2 a3 x + a4 y) x (a2 + a4 x + 2 a5 y)
  const Rational q0 = det(1, 2);
  const Rational q1 = det(1, 4) + 2 * det(3, 2);
  const Rational q2 = 2 * det(1, 5) + det(4, 2);
  const Rational q3 = 2 * det(3, 4);
  const Rational q4 = 4 * det(3, 5);
  const Rational q5 = 2 * det(4, 5);
  const auto q = [&](const Rational& x, const Rational& y) -> Rational {
    return q0 + q1 * x + q2 * y + q3 * x * x + q4 * x * y + q5 * y * y;
  };
  Minimum least{q(0, 0), Place::corner};
  least.lower(q(1, 0), Place::corner);
  least.lower(q(0, 1), Place::corner);
  const int edges[3][4] = {{0, 0, 1, 0}, {1, 0, -1, 1}, {0, 1, 0, -1}};  // a point and a direction
  for (const auto& e : edges) {
    const Rational square = q3 * e[2] * e[2] + q4 * e[2] * e[3] + q5 * e[3] * e[3];
    const Rational slope =
        q1 * e[2] + q2 * e[3] + 2 * q3 * e[0] * e[2] + q4 * (e[0] * e[3] + e[1] * e[2]) + 2 * q5 * e[1] * e[3];
    if (square == 0) continue;
    const Rational t = -slope / (2 * square);
    if (t > 0 && t < 1) least.lower(q(e[0] + t * e[2], e[1] + t * e[3]), Place::edge);
  }
  const Rational hessian = 4 * q3 * q5 - q4 * q4;
  if (hessian != 0) {
    const Rational x = (q4 * q2 - 2 * q5 * q1) / hessian;
    const Rational y = (q4 * q1 - 2 * q3 * q2) / hessian;
    if (x > 0 && y > 0 && x + y < 1) least.lower(q(x, y), Place::face);
  }
  return least;
}

inline Validity by_sign(const Rational& minimum) {
  return minimum > 0 ? Validity::valid : minimum < 0 ? Validity::invalid : Validity::degenerate;
}

/// n^(2p - 2) det J / p^2 at (i, j, k) / n, n = i + j + k: an integer where the control points are.
inline Integer lattice_jacobian(int degree, const std::vector<Point>& net, long long i, long long j, long long k) {
  const NetLayout& layout = NetLayout::of(degree);
  const NetLayout& lower = NetLayout::of(degree - 1);
  const long long weights[3] = {i, j, k};
  Integer u[2] = {0, 0}, v[2] = {0, 0};
  for (int m = 0; m < lower.size(); ++m) {
    const auto& e = lower.exponents(m);
    Integer basis = static_cast<long long>(lower.multinomial(m));
    for (std::size_t c = 0; c < 3; ++c)
      for (int f = 0; f < e[c]; ++f) basis *= weights[c];
    const Point& first = net[static_cast<std::size_t>(layout.index(e[0] + 1, e[1]))];
    const Vector d2 = net[static_cast<std::size_t>(layout.index(e[0], e[1] + 1))] - first;
    const Vector d3 = net[static_cast<std::size_t>(layout.index(e[0], e[1]))] - first;
    u[0] += basis * static_cast<long long>(d2.x), u[1] += basis * static_cast<long long>(d2.y);
    v[0] += basis * static_cast<long long>(d3.x), v[1] += basis * static_cast<long long>(d3.y);
  }
  return u[0] * v[1] - u[1] * v[0];
}

/// The sign of the least exact value found: on a lattice, then on ever finer ones around the least. A negative sign is
/// a proof, another one strong evidence.
inline int sign_of_sampled_minimum(int degree, const std::vector<Point>& net, long long n) {
  long long best_i = 0, best_j = 0;
  Integer least = lattice_jacobian(degree, net, 0, 0, n);
  const auto visit = [&](long long i, long long j) {
    if (i < 0 || j < 0 || i + j > n) return;
    const Integer value = lattice_jacobian(degree, net, i, j, n - i - j);
    if (value < least) least = value, best_i = i, best_j = j;
  };
  for (long long i = 0; i <= n; ++i)
    for (long long j = 0; i + j <= n; ++j) visit(i, j);
  for (int zoom = 0; zoom < 8 && least >= 0; ++zoom) {
    const long long i = best_i *= 2, j = best_j *= 2;
    n *= 2;
    least = lattice_jacobian(degree, net, best_i, best_j, n - best_i - best_j);
    for (long long a = i - 3; a <= i + 3; ++a)
      for (long long b = j - 3; b <= j + 3; ++b) visit(a, b);
  }
  return least.sign();
}

}  // namespace pliant::samples
