// tests/support/exact_elements.h: random elements with integer control points, many with a known least det J.
#pragma once
#include <algorithm>
#include <array>
#include <complex>
#include <cstdint>
#include <utility>
#include <vector>

#include "pliant/geometry/index.h"
#include "support/validity_oracle.h"

namespace pliant::samples {

/// Random numbers from a seed (SplitMix64, which costs nothing to start).
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed * 0xD1342543DE82EF95u) {}
  int integer(int low, int high) {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return low + static_cast<int>((z ^ (z >> 31)) % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(int n) { return integer(1, n) == 1; }

 private:
  std::uint64_t state_;
};

/// An element and what is known of its min det J.
struct KnownElement {
  IntegerNet net;
  Truth truth;
  double minimum = 0;  ///< a lower bound of |min det J|, if its sign is not 0
};

/// The elementary symmetric polynomial of degree k in these numbers.
template <class T>
T elementary(const std::vector<T>& values, int k) {
  std::vector<T> sums(index(k) + 1);
  sums[0] = 1;
  for (const T& v : values)
    for (std::size_t m = index(k); m >= 1; --m) sums[m] += sums[m - 1] * v;
  return sums[index(k)];
}

inline std::int64_t choose(int n, int k) { return k == 0 ? 1 : choose(n, k - 1) * (n - k + 1) / k; }

/// A multiple of every binomial coefficient (p choose k) with p <= 6.
inline constexpr std::int64_t blossom_scale = 60;
/// blossom_scale times the blossom of s^k, as a polynomial of degree p. Its values at corners of s are the control
/// points of s^k.
template <class T>
T blossom_of_power(int k, const std::vector<T>& arguments) {
  const int p = static_cast<int>(arguments.size());
  return elementary(arguments, k) * T(blossom_scale / choose(p, k));
}

/// The net of the polynomial with this blossom: each control point is the blossom at corners, as often as its exponents
/// say.
template <class Corner, class Blossom>
IntegerNet net_of(int p, const std::array<Corner, 3>& corners, Blossom blossom) {
  const NetLayout& layout = NetLayout::of(p);
  IntegerNet net;
  for (int n = 0; n < layout.size(); ++n) {
    std::vector<Corner> arguments;
    for (std::size_t c = 0; c < 3; ++c) arguments.insert(arguments.end(), index(layout.exponents(n)[c]), corners[c]);
    net.push_back(blossom(arguments));
  }
  return net;
}

using Gauss = std::complex<std::int64_t>;
inline std::int64_t cross(const Gauss& a, const Gauss& b) { return a.real() * b.imag() - a.imag() * b.real(); }
inline std::int64_t dot(const Gauss& a, const Gauss& b) { return a.real() * b.real() + a.imag() * b.imag(); }
using Triangle = std::array<Gauss, 3>;
inline std::int64_t twice_area(const Triangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

inline Triangle random_triangle(Draw& draw, int range, int unit) {
  Triangle t;
  do
    for (Gauss& c : t) c = Gauss(unit * draw.integer(-range, range), unit * draw.integer(-range, range));
  while (twice_area(t) <= 0);
  return t;
}

/// Where r is: sign 1 outside of the triangle, or 0 in it, and then at a corner, on an edge or inside.
inline Truth location(const Triangle& t, const Gauss& r) {
  int zeros = 0;
  for (std::size_t e = 0; e < 3; ++e) {
    const std::int64_t side = cross(t[(e + 1) % 3] - t[e], r - t[e]);
    if (side < 0) return {1, Place::corner};
    zeros += side == 0;
  }
  return {0, zeros == 2 ? Place::corner : zeros == 1 ? Place::edge : Place::face};
}

/// A corner, a point at quarters of an edge (corners have multiples of 4 as coordinates), or any integer point nearby.
inline Gauss random_root(Draw& draw, const Triangle& t, int range) {
  const std::size_t e = index(draw.integer(0, 2));
  const int kind = draw.integer(0, 7);
  if (kind == 0) return t[e];
  if (kind == 1) return t[e] + (t[(e + 1) % 3] - t[e]) / std::int64_t{4} * std::int64_t{draw.integer(1, 3)};
  return Gauss(draw.integer(-range, range), draw.integer(-range, range));
}

/// The element chi(z) = 2^k p (z - r)^p + p tilt conj(z) on a triangle of the complex plane. With n = p - 1 its
/// det J = p^2 (4^k p^2 |z - r|^(2 n) - |tilt|^2) (twice the triangle's area), which grows with the distance to r.
inline KnownElement tilted_power(int p, Draw& draw) {
  const Triangle t = random_triangle(draw, 2, 4);
  const Gauss r = random_root(draw, t, 8);
  const Gauss tilt = draw.one_in(3) ? Gauss(0, 0) : Gauss(draw.integer(-3, 3), draw.integer(-9, 9));
  const std::int64_t factor = std::int64_t{1} << draw.integer(0, 16);
  KnownElement result;
  result.net = net_of(p, t, [&](const std::vector<Gauss>& u) -> std::array<std::int64_t, 2> {
    Gauss product(p * factor, 0), sum(0, 0);
    for (const Gauss& z : u) product *= z - r, sum += std::conj(z);
    product += tilt * sum;
    return {product.real(), product.imag()};
  });
  // The sign of 4^k p^2 (above / below)^n - |tilt|^2, where above / below is the square of a distance.
  using Long = Fixed<512>;
  const auto sign_at = [&](std::int64_t above, std::int64_t below) {
    Long left = Long(factor) * factor * (p * p), right = std::norm(tilt);
    for (int m = 1; m < p; ++m) left *= above, right *= below;
    return sign_of(Long(left - right));
  };
  for (std::size_t e = 0; e < 3; ++e) {
    const Gauss side = t[(e + 1) % 3] - t[e];
    result.truth.lower(sign_at(std::norm(r - t[e]), 1), Place::corner);
    const std::int64_t along = dot(side, r - t[e]), across = cross(side, r - t[e]);
    if (along > 0 && along < std::norm(side))
      result.truth.lower(sign_at(across * across, std::norm(side)), Place::edge);
  }
  if (location(t, r).sign == 0) result.truth.lower(-sign_of(std::norm(tilt)), Place::face);
  if (location(t, r).sign == 0)
    result.minimum = static_cast<double>(p * p * std::norm(tilt) * twice_area(t));
  else
    result.minimum = HUGE_VAL;  // it is not known, so that "degenerate" always is a wrong answer
  return result;
}

/// A complex polynomial f, so that det J = |f'|^2 (twice the triangle's area); the p - 1 roots of f' are integer
/// points.
inline KnownElement many_roots(int p, Draw& draw) {
  const Triangle t = random_triangle(draw, 1, 4);
  std::vector<Gauss> derivative{Gauss(1, 0)};  // coefficients, lowest first
  KnownElement result;
  for (int m = 1; m < p; ++m) {
    const Gauss r = random_root(draw, t, 5);
    const Truth at_root = location(t, r);
    if (at_root.sign == 0 && (result.truth.sign > 0 || at_root.place < result.truth.place)) result.truth = at_root;
    derivative.push_back(Gauss(0, 0));
    for (std::size_t k = derivative.size(); k-- > 0;)
      derivative[k] = (k > 0 ? derivative[k - 1] : Gauss(0, 0)) - r * derivative[k];
  }
  result.net = net_of(p, t, [&](const std::vector<Gauss>& u) -> std::array<std::int64_t, 2> {
    Gauss sum(0, 0);
    for (int k = 1; k <= p; ++k) sum += derivative[index(k - 1)] * blossom_of_power(k, u) * Gauss(60 / k, 0);
    return {sum.real(), sum.imag()};
  });
  result.minimum = HUGE_VAL;
  return result;
}

/// The element chi = (U(l) + b l m, m), where l and m are linear forms with m = 0 on edge 01. Its det J is a multiple
/// of U'(l) + b m, with U'(s) = 2^k (a s - r)^q + c and b about 2^k. The minimum of this is c, at the point of edge 01
/// with a l = r, and for b = 0 on a whole line.
inline KnownElement strip(int p, Draw& draw) {
  using Forms = std::array<std::int64_t, 2>;  // l, m
  std::array<Forms, 3> corners;
  std::int64_t area = 0;
  do {
    corners = {Forms{draw.integer(-5, 5), 0}, Forms{draw.integer(-5, 5), 0},
               Forms{draw.integer(-5, 5), draw.integer(1, 4)}};
    area = (corners[1][0] - corners[0][0]) * corners[2][1];
  } while (area <= 0);
  const int q = p >= 5 && draw.one_in(2) ? 4 : 2;
  const std::int64_t a = q == 2 && draw.one_in(2) ? 3 : 1;
  const std::int64_t r = draw.integer(static_cast<int>(a * corners[0][0]), static_cast<int>(a * corners[1][0]));
  // Few elements have their minimum on a line: these are the slowest to decide, or, if c is small, are not decided.
  const bool is_line = draw.one_in(50);
  const std::int64_t factor = std::int64_t{1} << draw.integer(0, is_line ? 16 : 24);
  const std::int64_t b = is_line ? 0 : factor * draw.integer(1, 3);
  const std::int64_t c = draw.integer(-1, 1);
  KnownElement result;
  const auto blossom_1 = [](const std::vector<Forms>& u, std::size_t form, int k) {
    std::vector<std::int64_t> values;
    for (const Forms& f : u) values.push_back(f[form]);
    return blossom_of_power(k, values);
  };
  result.net = net_of(p, corners, [&](const std::vector<Forms>& u) -> std::array<std::int64_t, 2> {
    std::int64_t x = 60 * c * blossom_1(u, 0, 1);
    std::int64_t power = 1;  // (-r)^(q - k), from k = q on
    for (int k = q; k >= 0; --k, power *= -r)
      x += 60 / (k + 1) * factor * choose(q, k) * power *
           (k == q             ? (q == 2 ? a * a : 1)
            : k == 1 && q == 2 ? a
                               : 1) *
           blossom_1(u, 0, k + 1);
    std::int64_t mixed = 0;
    for (std::size_t i = 0; i < u.size(); ++i)
      for (std::size_t j = 0; j < u.size(); ++j)
        if (i != j) mixed += u[i][0] * u[j][1];
    x += 60 * b * (blossom_scale / (p * (p - 1))) * mixed;
    return {x, blossom_1(u, 1, 1)};
  });
  for (const Forms& f : corners) {
    std::int64_t square = 1;
    for (int m = 0; m < q; ++m) square *= a * f[0] - r;
    result.truth.lower(sign_of(factor * square + c + b * f[1]), Place::corner);
  }
  result.truth.lower(sign_of(c), Place::edge);
  result.minimum = static_cast<double>(60 * blossom_scale * blossom_scale * area);
  return result;
}

/// Applies a random affine map of the plane that keeps the orientation.
inline void map_affinely(KnownElement& element, Draw& draw) {
  std::int64_t m[4];
  do
    for (std::int64_t& x : m) x = draw.integer(-2, 2);
  while (m[0] * m[3] - m[1] * m[2] <= 0);
  for (auto& [x, y] : element.net) {
    const std::int64_t image[2] = {m[0] * x + m[1] * y, m[2] * x + m[3] * y};
    x = image[0], y = image[1];
  }
  element.minimum *= static_cast<double>(m[0] * m[3] - m[1] * m[2]);
}

/// Applies shears in x and in y in turn, until coordinates are as long as doubles can hold. det J stays exactly as it
/// was, but is now a sum of products of 100 bits that cancel.
inline void shear_far(IntegerNet& net, Draw& draw) {
  std::int64_t m[2][2] = {{1, 0}, {0, 1}};
  std::int64_t extent = 1;
  for (const auto& [x, y] : net) extent = std::max({extent, std::abs(x), std::abs(y)});
  const auto longest = [&] {
    return std::max(std::abs(m[0][0]) + std::abs(m[0][1]), std::abs(m[1][0]) + std::abs(m[1][1]));
  };
  for (std::size_t row = 0; longest() <= (std::int64_t{1} << 50) / extent; row = 1 - row) {
    const int k = draw.integer(1, 3);
    for (std::size_t c = 0; c < 2; ++c) m[row][c] += k * m[1 - row][c];
  }
  for (auto& [x, y] : net) {
    const std::int64_t image[2] = {m[0][0] * x + m[0][1] * y, m[1][0] * x + m[1][1] * y};
    x = image[0], y = image[1];
  }
}

/// A net with some control points near the origin and the others far away, all of these on one ray. The points are
/// doubles, but their differences are not, so the signs that floating point gives are noise.
inline IntegerNet unbalanced_net(int p, Draw& draw) {
  const auto mantissa = [&] {
    return (std::int64_t{1} << 52) + (std::int64_t{draw.integer(0, 1 << 25)} << 26) + draw.integer(0, 1 << 26);
  };
  const std::int64_t far[2] = {mantissa() * 128, mantissa() * 128};
  IntegerNet net;
  for (int n = 0; n < net_size(p); ++n) {
    const int factor = n == 0 ? 0 : draw.integer(0, 2);
    if (factor == 0)
      net.push_back({draw.integer(-999, 999), draw.integer(-999, 999)});
    else
      net.push_back({factor * far[0], factor * far[1]});
  }
  return net;
}

/// A straight triangle whose control points are moved by small integers. Some have two edges in line at a corner, a
/// collapsed edge, or are collapsed altogether.
inline IntegerNet random_net(int p, Draw& draw) {
  const NetLayout& layout = NetLayout::of(p);
  const int size = draw.integer(1, 3), range = draw.integer(1, size + 1);
  IntegerNet net;
  for (int n = 0; n < layout.size(); ++n) {
    const auto [i, j, k] = layout.exponents(n);
    net.push_back({size * j + draw.integer(-range, range), size * k + draw.integer(-range, range)});
  }
  const int kind = draw.integer(0, 15);
  const int e = draw.integer(0, 2);
  if (kind == 0) {  // the edges that meet at corner e leave it in the same direction, or the opposite one
    const auto from = net[index(e)];
    const auto first = net[index(layout.edge_index(e, 1))];
    auto& second = net[index(layout.edge_index((e + 2) % 3, p - 1))];
    for (std::size_t c = 0; c < 2; ++c) second[c] = from[c] + draw.integer(-1, 2) * (first[c] - from[c]);
  }
  if (kind == 1)
    for (int k = 1; k <= p; ++k) net[index(layout.edge_index(e, k))] = net[index(e)];
  if (kind == 2 && draw.one_in(4)) {
    const int slope = draw.integer(-2, 2);
    for (auto& [x, y] : net) y = slope * x;
  }
  return net;
}

}  // namespace pliant::samples
