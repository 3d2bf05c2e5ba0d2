// tests/support/validity_oracle.h: the sign of min det J in integers, by other ways than the library's.
#pragma once
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"
#include "support/exact_jacobian.h"

namespace pliant::samples {

__extension__ typedef __int128 Wide;
template <unsigned bits>
using Fixed = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    bits, bits, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>>;

/// A net of integers, in the order of NetLayout.
using IntegerNet = std::vector<std::array<std::int64_t, 2>>;

/// What is true of an element: the sign of min det J, and where it is attained, at a corner, else on an edge, else
/// inside (so {-1, face} is negative in the interior only).
struct Truth {
  int sign = 1;
  Place place = Place::corner;
  void lower(int candidate, Place where) {
    if (candidate < sign) sign = candidate, place = where;
  }
};

template <class Int>
int sign_of(const Int& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// The truth about a quadratic element, by calculus on the power form of det J. Int must have room for
/// 2^33 (greatest coordinate)^6.
template <class Int>
Truth quadratic_truth(const IntegerNet& net) {
  Int a[6][2];  // chi = a0 + a1 x + a2 y + a3 x^2 + a4 x y + a5 y^2
  for (std::size_t c = 0; c < 2; ++c) {
    const auto b = [&](std::size_t n) { return Int(net[n][c]); };
    a[1][c] = 2 * (b(3) - b(0)), a[2][c] = 2 * (b(5) - b(0));
    a[3][c] = b(0) - 2 * b(3) + b(1), a[4][c] = 2 * (b(0) - b(3) - b(5) + b(4)), a[5][c] = b(0) - 2 * b(5) + b(2);
  }
  const auto det = [&](int m, int n) { return Int(a[m][0] * a[n][1] - a[m][1] * a[n][0]); };
  const Int q0 = det(1, 2), q1 = det(1, 4) + 2 * det(3, 2), q2 = 2 * det(1, 5) + det(4, 2);
  const Int q3 = 2 * det(3, 4), q4 = 4 * det(3, 5), q5 = 2 * det(4, 5);
  Truth truth;
  const Int corners[3] = {q0, q0 + q1 + q3, q0 + q2 + q5};
  for (const Int& value : corners) truth.lower(sign_of(value), Place::corner);
  // det J at t on an edge is start + slope t + square t^2.
  const auto edge = [&](const Int& start, const Int& slope, const Int& square) {
    if (square > 0 && slope < 0 && -slope < 2 * square)
      truth.lower(sign_of(Int(4 * square * start - slope * slope)), Place::edge);
  };
  edge(q0, q1, q3);
  edge(q0, q2, q5);
  edge(corners[1], q2 + q4 - q1 - 2 * q3, q3 - q4 + q5);
  const Int hessian = 4 * q3 * q5 - q4 * q4;
  if (hessian > 0 && q3 > 0) {
    const Int x = q4 * q2 - 2 * q5 * q1, y = q4 * q1 - 2 * q3 * q2;  // the stationary point, times the Hessian
    if (x > 0 && y > 0 && x + y < hessian) truth.lower(sign_of(Int(2 * q0 * hessian + q1 * x + q2 * y)), Place::face);
  }
  return truth;
}

/// det J, in Bernstein form, of an element of degree up to 6; computed by way of the power form of its map.
template <class Int>
class IntegerJacobian {
 public:
  IntegerJacobian(int p, const IntegerNet& net) : degree_(2 * (p - 1)) {
    const auto x = power_form(p, net, 0), y = power_form(p, net, 1);
    Table product{};
    for (int a = 0; a <= p; ++a)
      for (int b = 0; a + b <= p; ++b)
        for (int c = 0; c <= p; ++c)
          for (int d = 0; c + d <= p; ++d) {
            if (a + c < 1 || b + d < 1) continue;  // x^(a + c - 1) y^(b + d - 1) of x_u y_v - x_v y_u
            if (const int minor = a * d - b * c; minor != 0)
              product[index(a + c - 1)][index(b + d - 1)] += minor * x[index(a)][index(b)] * y[index(c)][index(d)];
          }
    root_.assign(index((degree_ + 1) * (degree_ + 1)), Int(0));
    for (int j = 0; j <= degree_; ++j)
      for (int k = 0; j + k <= degree_; ++k)
        for (int a = 0; a <= j; ++a)
          for (int b = 0; b <= k; ++b)
            // (j choose a) a! (k choose b) b! (d - a - b)!
            entry(root_, j, k) += factorial(j) / factorial(j - a) * (factorial(k) / factorial(k - b)) *
                                  factorial(degree_ - a - b) * product[index(a)][index(b)];
    for (const Int& c : root_) greatest_ = std::max(greatest_, std::fabs(static_cast<double>(c)));
  }

  /// max |coefficient| of det J, in units of the net.
  double greatest() const { return greatest_ / static_cast<double>(factorial(degree_)); }

  /// How deep bisections may go without overflow of integers with that many bits.
  int depth_of(int bits) const { return static_cast<int>(bits - 1 - std::ceil(std::log2(greatest_ + 1))) / degree_; }

  /// What bisections to a depth prove about the minimum: in units of `greatest` it is within [lower, upper], and a
  /// `sign` of -1 or 1 is proved. A `sign` of 0 means that the sign is not known.
  struct Enclosure {
    int sign = 1;
    double lower = HUGE_VAL, upper = HUGE_VAL;
    bool is_zero() const { return lower == 0 && upper == 0; }
    bool is_decided() const { return sign != 0 || is_zero(); }
  };
  /// With a tolerance, only values below -tolerance count as negative. A piece is closed if its coefficients are above
  /// a sixteenth of that, since its corners may be several times as far from zero as its coefficients.
  Enclosure enclose(int greatest_depth, int most_pieces = 500, double tolerance = 0) const {
    if (greatest_ == 0) return {0, 0, 0};
    Enclosure result;
    visit(root_, {0, greatest_depth, tolerance}, most_pieces, result);
    return result;
  }
  int sign_at_corners() const {
    return std::min(
        {sign_of(entry(root_, 0, 0)), sign_of(entry(root_, degree_, 0)), sign_of(entry(root_, 0, degree_))});
  }

 private:
  static constexpr std::size_t most = 11;  // p = 6
  using Table = std::array<std::array<Int, most>, most>;

  static std::int64_t factorial(int n) {
    static const auto table = [] {
      std::array<std::int64_t, most> f{1};
      for (std::size_t m = 1; m < most; ++m) f[m] = static_cast<std::int64_t>(m) * f[m - 1];
      return f;
    }();
    return table[index(n)];
  }
  static std::int64_t binomial(int n, int k) { return factorial(n) / (factorial(k) * factorial(n - k)); }

  static Table power_form(int p, const IntegerNet& net, std::size_t coordinate) {
    const NetLayout& layout = NetLayout::of(p);
    Table result{};
    for (int n = 0; n < layout.size(); ++n) {
      const auto [i, j, k] = layout.exponents(n);
      const Int scale = static_cast<std::int64_t>(layout.multinomial(n)) * Int(net[index(n)][coordinate]);
      for (int a = 0; a <= i; ++a)  // (1 - x - y)^i
        for (int b = 0; a + b <= i; ++b)
          result[index(j + a)][index(k + b)] += ((a + b) % 2 ? -scale : scale) * binomial(i, a) * binomial(i - a, b);
    }
    return result;
  }

  using Coefficients = std::vector<Int>;
  template <class Any>
  auto& entry(Any& piece, int j, int k) const {
    return piece[index(j * (degree_ + 1) + k)];
  }

  struct Limits {
    int depth, greatest_depth;
    double tolerance;
  };
  void visit(const Coefficients& piece, const Limits& limits, int& pieces_left, Enclosure& result) const {
    if (result.sign < 0) return;
    const auto& [depth, greatest_depth, tolerance] = limits;
    const long double unit = std::ldexp(static_cast<long double>(greatest_), depth * degree_);
    const auto relative = [&](const Int& x) { return static_cast<double>(static_cast<long double>(x) / unit); };
    const Int& least_corner =
        std::min({entry(piece, 0, 0), entry(piece, degree_, 0), entry(piece, 0, degree_)}, std::less<Int>());
    result.upper = std::min(result.upper, relative(least_corner));
    if (least_corner < 0 && relative(least_corner) < -tolerance) {
      result.sign = -1;
      return;
    }
    const Int* least = &least_corner;
    for (int j = 0; j <= degree_; ++j)
      for (int k = 0; j + k <= degree_; ++k)
        if (entry(piece, j, k) < *least) least = &entry(piece, j, k);
    if (*least >= 0 || relative(*least) >= -tolerance / 16 || depth == greatest_depth || pieces_left == 0) {
      result.lower = std::min(result.lower, relative(*least));
      if (*least < 0 || least_corner == 0) result.sign = 0;
      return;
    }
    --pieces_left;
    Coefficients first(piece.size()), second(piece.size());
    // The piece (v0, v1, v2) becomes (v2, v0, m) and (v1, v2, m), where m is the middle of v0 v1.
    for (int k = 0; k <= degree_; ++k) {
      const int n = degree_ - k;
      Coefficients row;
      for (int j = 0; j <= n; ++j) row.push_back(entry(piece, j, k));
      for (int t = 0; t <= n; ++t) {
        const Int scale = Int(1) << (degree_ - t);
        entry(first, n - t, t) = row[0] * scale;
        entry(second, k, t) = row[index(n - t)] * scale;
        for (int j = 0; j < n - t; ++j) row[index(j)] += row[index(j + 1)];
      }
    }
    visit(first, {depth + 1, greatest_depth, tolerance}, pieces_left, result);
    visit(second, {depth + 1, greatest_depth, tolerance}, pieces_left, result);
  }

  int degree_;
  Coefficients root_;  // the coefficients of det J times the factorial of its degree
  double greatest_ = 0;
};

}  // namespace pliant::samples
