// lib/pliant/geometry/predicates.cpp: a floating-point filter, then integers for what it leaves open.
#include "pliant/geometry/predicates.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace pliant {
namespace {

using Integer = boost::multiprecision::cpp_int;

// Bounds of the rounding errors, relative to the sum of the absolute values of all products (Shewchuk 1997). They hold
// where no product underflows; what underflow may add is below the floor, which is absolute.
constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;
constexpr double orient_bound = (3 + 16 * half_ulp) * half_ulp;
constexpr double circle_bound = (10 + 96 * half_ulp) * half_ulp;
constexpr double orient_floor = 1e-300;
constexpr double circle_floor = 1e-280;

/// The coordinates of n points, all multiplied by the power of two that makes integers of them.
template <std::size_t n>
std::array<std::array<Integer, 2>, n> scaled(const std::array<Point, n>& points) {
  int least = std::numeric_limits<int>::max();
  const auto mantissa_of = [](double x, int& exponent) {
    const double fraction = std::frexp(x, &exponent);
    exponent -= 53;
    return static_cast<long long>(std::ldexp(fraction, 53));
  };
  for (const Point& p : points)
    for (const double x : {p.x, p.y}) {
      int exponent = 0;
      if (mantissa_of(x, exponent) != 0) least = std::min(least, exponent);
    }
  std::array<std::array<Integer, 2>, n> result;
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<double, 2> xy{points[i].x, points[i].y};
    for (std::size_t c = 0; c < 2; ++c) {
      int exponent = 0;
      const long long mantissa = mantissa_of(xy[c], exponent);
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

#ifdef __SIZEOF_INT128__
__extension__ using Wide = __int128;
__extension__ using WideBits = unsigned __int128;

/// A sum, in 256 bits, of products of integers below 2^125 in magnitude.
class WideSum {
 public:
  void add_product(Wide a, Wide b) {
    const bool is_negative = (a < 0) != (b < 0);
    const auto x = static_cast<WideBits>(a < 0 ? -a : a), y = static_cast<WideBits>(b < 0 ? -b : b);
    const WideBits x0 = low(x), x1 = x >> 64, y0 = low(y), y1 = y >> 64;
    const WideBits bottom = x0 * y0, cross1 = x0 * y1 + (bottom >> 64), cross2 = x1 * y0 + low(cross1);
    const WideBits head = x1 * y1 + (cross1 >> 64) + (cross2 >> 64), tail = (cross2 << 64) | low(bottom);
    const WideBits before = tail_;
    tail_ = is_negative ? tail_ - tail : tail_ + tail;
    const WideBits carry = is_negative ? before < tail : tail_ < before;
    head_ = is_negative ? head_ - head - carry : head_ + head + carry;
  }
  int sign() const { return static_cast<Wide>(head_) < 0 ? -1 : head_ != 0 || tail_ != 0; }

 private:
  static WideBits low(WideBits x) { return x & ~std::uint64_t{0}; }
  WideBits head_ = 0, tail_ = 0;
};

/// Whether x - y is a double, so that subtracting does not round.
bool subtracts_exactly(double x, double y) {
  const double difference = x - y, back = x - difference;
  return (x - (difference + back)) + (back - y) == 0;
}

/// in_circle for points whose differences are doubles of similar size; empty for others. Grids have such points, and
/// there every edge needs the exact answer. This way is several times as fast as integers of any length.
std::optional<int> in_circle_of_near(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<std::int64_t, 6> xy{};
  const std::array<double, 6> differences{a.x - d.x, a.y - d.y, b.x - d.x, b.y - d.y, c.x - d.x, c.y - d.y};
  double largest = 0;
  for (const double x : differences) largest = std::max(largest, std::fabs(x));
  if (!(largest > 1e-200 && largest < 1e200)) return std::nullopt;
  const double scale = std::ldexp(1.0, 60 - std::ilogb(largest));
  for (std::size_t k = 0; k < 6; ++k) {
    const double x = scale * differences[k];
    xy[k] = static_cast<std::int64_t>(x);
    const bool has_underflowed = x == 0 && differences[k] != 0;
    if (static_cast<double>(xy[k]) != x || has_underflowed) return std::nullopt;
  }
  for (const Point& p : {a, b, c})
    if (!subtracts_exactly(p.x, d.x) || !subtracts_exactly(p.y, d.y)) return std::nullopt;
  const auto lift = [&xy](std::size_t i) { return Wide{xy[i]} * xy[i] + Wide{xy[i + 1]} * xy[i + 1]; };
  const auto minor = [&xy](std::size_t i, std::size_t j) { return Wide{xy[i]} * xy[j + 1] - Wide{xy[i + 1]} * xy[j]; };
  WideSum det;
  det.add_product(lift(0), minor(2, 4));
  det.add_product(lift(2), minor(4, 0));
  det.add_product(lift(4), minor(0, 2));
  return det.sign();
}
#else
std::optional<int> in_circle_of_near(const Point&, const Point&, const Point&, const Point&) { return std::nullopt; }
#endif

}  // namespace

int orient2d(const Point& a, const Point& b, const Point& c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  // Overflow makes the bound infinite or one side of the comparison NaN. Both lead to the exact stage.
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
  // What an inner product loses by underflow is multiplied by a lift, so the floor only holds while lifts are bounded.
  const bool is_floor_valid = std::max({lift_u, lift_v, lift_w}) < 1e30;
  if (is_floor_valid && std::fabs(det) > circle_bound * permanent + circle_floor) return sign(det);
  if (const auto answer = in_circle_of_near(a, b, c, d)) return *answer;
  return exact_in_circle(a, b, c, d);
}

}  // namespace pliant
