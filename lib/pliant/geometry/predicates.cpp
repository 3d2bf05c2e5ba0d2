#include "pliant/geometry/predicates.h"  // lib/pliant/geometry/predicates.cpp: filtered, then integer arithmetic

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace pliant {
namespace {

using Integer = boost::multiprecision::cpp_int;

// Bounds of the rounding errors relative to the sum of the absolute values of all products (Shewchuk 1997), valid
// where no product underflows: what underflow may add is below the absolute floor.
constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;
constexpr double orient_bound = (3 + 16 * half_ulp) * half_ulp;
constexpr double circle_bound = (10 + 96 * half_ulp) * half_ulp;
constexpr double orient_floor = 1e-300;
constexpr double circle_floor = 1e-280;

/// The coordinates of n points as integers: all multiplied by the same power of two.
template <std::size_t n>
std::array<std::array<Integer, 2>, n> scaled(const std::array<Point, n>& points) {
  int least = std::numeric_limits<int>::max();
  const auto visit = [](double x, int& exponent) {
    const double fraction = std::frexp(x, &exponent);
    exponent -= 53;
    return static_cast<long long>(std::ldexp(fraction, 53));
  };
  for (const Point& p : points)
    for (const double x : {p.x, p.y}) {
      int exponent = 0;
      if (visit(x, exponent) != 0) least = std::min(least, exponent);
    }
  std::array<std::array<Integer, 2>, n> result;
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<double, 2> xy{points[i].x, points[i].y};
    for (std::size_t c = 0; c < 2; ++c) {
      int exponent = 0;
      const long long mantissa = visit(xy[c], exponent);
      if (mantissa == 0) continue;
      result[i][c] = mantissa;
      result[i][c] <<= static_cast<unsigned>(exponent - least);
    }
  }
  return result;
}

int exact_orient2d(const Point& a, const Point& b, const Point& c) {
  const auto p = scaled<3>({a, b, c});
  const Integer det = (p[0][0] - p[2][0]) * (p[1][1] - p[2][1]) - (p[0][1] - p[2][1]) * (p[1][0] - p[2][0]);
  return det.sign();
}

int exact_in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  auto p = scaled<4>({a, b, c, d});
  std::array<Integer, 3> lift;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i][0] -= p[3][0];
    p[i][1] -= p[3][1];
    lift[i] = p[i][0] * p[i][0] + p[i][1] * p[i][1];
  }
  const auto minor = [&p](std::size_t i, std::size_t j) -> Integer { return p[i][0] * p[j][1] - p[i][1] * p[j][0]; };
  const Integer det = lift[0] * minor(1, 2) + lift[1] * minor(2, 0) + lift[2] * minor(0, 1);
  return det.sign();
}

int sign(double x) { return (x > 0) - (x < 0); }

}  // namespace

int orient2d(const Point& a, const Point& b, const Point& c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  // Overflow makes the bound infinite or the comparison one with NaN: both lead to the exact stage.
  if (std::fabs(det) > orient_bound * (std::fabs(left) + std::fabs(right)) + orient_floor) return sign(det);
  return exact_orient2d(a, b, c);
}

int in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Vector u = a - d, v = b - d, w = c - d;
  const double vw1 = v.x * w.y, vw2 = v.y * w.x, wu1 = w.x * u.y, wu2 = w.y * u.x, uv1 = u.x * v.y, uv2 = u.y * v.x;
  const double lift_u = squared_length(u), lift_v = squared_length(v), lift_w = squared_length(w);
  const double det = lift_u * (vw1 - vw2) + lift_v * (wu1 - wu2) + lift_w * (uv1 - uv2);
  const double permanent = lift_u * (std::fabs(vw1) + std::fabs(vw2)) + lift_v * (std::fabs(wu1) + std::fabs(wu2)) +
                           lift_w * (std::fabs(uv1) + std::fabs(uv2));
  // An inner product below the floor can underflow while its outer factor is huge, so the lifts must be tame as well.
  const bool tame = std::max({lift_u, lift_v, lift_w}) < 1e30;
  if (tame && std::fabs(det) > circle_bound * permanent + circle_floor) return sign(det);
  return exact_in_circle(a, b, c, d);
}

}  // namespace pliant
