// tests/support/quadratic_forms.h: the least places of quadratic forms and of their quotients on a triangle.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "support/cut_polygon.h"

namespace pliant::samples {

/// Coordinates xi of a point of the triangle: not negative, and their sum is 1.
using BarycentricPlace = std::array<Real, 3>;
/// A symmetric matrix m, for the form xi^T m xi.
using QuadraticForm = std::array<std::array<Real, 3>, 3>;

inline Real value(const QuadraticForm& m, const BarycentricPlace& x) {
  Real sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) sum += m[i][j] * x[i] * x[j];
  return sum;
}
inline Real determinant(const QuadraticForm& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}
inline QuadraticForm difference(const QuadraticForm& a, Real t, const QuadraticForm& b) {
  QuadraticForm m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = a[i][j] - t * b[i][j];
  return m;
}
/// Keeps the place with the least value among what is offered.
template <class Value>
struct Lowest {
  Value value_at;
  BarycentricPlace place{};
  Real least = HUGE_VALL;
  void offer(BarycentricPlace x) {
    const Real sum = x[0] + x[1] + x[2];
    for (Real& c : x) c /= sum;
    if (!(std::min({x[0], x[1], x[2]}) >= 0)) return;
    if (const Real v = value_at(x); v < least) {
      least = v;
      place = x;
    }
  }
};
template <class Value>
Lowest<Value> lowest_of(Value value_at) {
  return {value_at};
}
/// The columns of the adjugate of a symmetric matrix: solutions of m x = 0 where it is singular.
inline std::array<BarycentricPlace, 3> adjugate(const QuadraticForm& m) {
  std::array<BarycentricPlace, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &u = m[(i + 1) % 3], &v = m[(i + 2) % 3];
    rows[i] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }
  return rows;
}
/// Where in the triangle a quadratic form is least.
inline BarycentricPlace lowest_form(const QuadraticForm& m) {
  auto best = lowest_of([&m](const BarycentricPlace& x) { return value(m, x); });
  for (std::size_t i = 0; i < 3; ++i) {
    BarycentricPlace corner{}, edge{};
    corner[i] = 1;
    best.offer(corner);
    const std::size_t j = (i + 1) % 3;
    edge[i] = m[j][j] - m[i][j];
    edge[j] = m[i][i] - m[i][j];
    best.offer(edge);
  }
  const auto rows = adjugate(m);  // m x = constant
  best.offer({rows[0][0] + rows[1][0] + rows[2][0], rows[0][1] + rows[1][1] + rows[2][1],
              rows[0][2] + rows[1][2] + rows[2][2]});
  return best.place;
}
/// Where in the triangle n / s is least; s is positive, and n / s nowhere below -1.
inline BarycentricPlace lowest_quotient(const QuadraticForm& n, const QuadraticForm& s) {
  auto best = lowest_of([&](const BarycentricPlace& x) { return value(n, x) / value(s, x); });
  for (std::size_t i = 0; i < 3; ++i) {
    BarycentricPlace corner{};
    corner[i] = 1;
    best.offer(corner);
    const std::size_t j = (i + 1) % 3;
    const Real a = n[i][i] * s[i][j] - n[i][j] * s[i][i], b = n[i][i] * s[j][j] - n[j][j] * s[i][i],
               c = n[i][j] * s[j][j] - n[j][j] * s[i][j];
    const Real square = b * b - 4 * a * c;
    if (square < 0) continue;
    const Real half = -(b + (b < 0 ? -1 : 1) * std::sqrt(square)) / 2;  // c r^2 + b r + a = 0
    for (const auto& [over, under] : {std::pair{half, c}, std::pair{a, half}}) {
      BarycentricPlace edge{};
      edge[i] = under;
      edge[j] = over;
      best.offer(edge);
    }
  }
  // det(n - t s) = 0: the coefficients from four values, the roots in [-1, least] between stationary points.
  const Real d0 = determinant(n), d3 = -determinant(s);
  const Real plus = determinant(difference(n, 1, s)), minus = determinant(difference(n, -1, s));
  const Real d2 = (plus + minus) / 2 - d0, d1 = (plus - minus) / 2 - d3;
  const auto cubic = [&](Real t) { return d0 + t * (d1 + t * (d2 + t * d3)); };
  std::vector<Real> ends{-1};
  const Real inner = d2 * d2 - 3 * d1 * d3;
  if (inner > 0) {
    const Real q = -(d2 + (d2 < 0 ? -1 : 1) * std::sqrt(inner));
    Real r1 = q / (3 * d3), r2 = d1 / q;
    if (r1 > r2) std::swap(r1, r2);
    for (const Real r : {r1, r2})
      if (r > -1 && r < best.least) ends.push_back(r);
  }
  ends.push_back(best.least);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    Real low = ends[k], high = ends[k + 1], at_low = cubic(low), at_high = cubic(high);
    if ((at_low < 0) == (at_high < 0)) continue;
    for (int steps = 0; steps < 100 && high - low > 1e-18L; ++steps) {
      Real t = steps % 3 == 2 ? (low + high) / 2 : low - at_low * (high - low) / (at_high - at_low);
      if (!(t > low && t < high)) t = (low + high) / 2;
      const Real v = cubic(t);
      ((v < 0) == (at_low < 0) ? std::pair<Real&, Real&>(low, at_low) : std::pair<Real&, Real&>(high, at_high)) =
          std::pair{t, v};
    }
    for (const BarycentricPlace& x : adjugate(difference(n, low, s))) best.offer(x);
  }
  return best.place;
}

}  // namespace pliant::samples
