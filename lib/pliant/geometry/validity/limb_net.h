// lib/pliant/geometry/validity/limb_net.h: Bernstein coefficients that are long integers, side by side (private).
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pliant/geometry/lattice.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {

using Limb = std::uint64_t;

/// A net in lattice order whose coefficients are integers of `width` limbs each, the lowest first, in two's complement.
/// All have the same length, so that a bisection allocates twice and not once for each sum.
class LimbNet {
 public:
  LimbNet(int degree, std::size_t width)
      : degree_(degree), width_(width), limbs_(static_cast<std::size_t>(net_size(degree)) * width) {}

  int degree() const { return degree_; }
  std::size_t width() const { return width_; }
  int size() const { return net_size(degree_); }
  Limb* at(int n) { return limbs_.data() + static_cast<std::size_t>(n) * width_; }
  const Limb* at(int n) const { return limbs_.data() + static_cast<std::size_t>(n) * width_; }

  int sign(int n) const {
    const Limb* x = at(n);
    if (static_cast<std::int64_t>(x[width_ - 1]) < 0) return -1;
    return std::any_of(x, x + width_, [](Limb limb) { return limb != 0; }) ? 1 : 0;
  }

  /// The coefficient times 2^exponent, to a relative error of 2^-51 (0 where that underflows).
  double value(int n, int exponent) const {
    const Limb* x = at(n);
    std::size_t top = width_ - 1;
    // A limb that only repeats the sign of the one below adds nothing.
    while (top > 0 && x[top] == sign_limb(x[top - 1])) --top;
    double result = static_cast<double>(static_cast<std::int64_t>(x[top]));
    if (top == 0) return std::ldexp(result, exponent);
    result = result * 0x1p64 + static_cast<double>(x[top - 1]);
    return std::ldexp(result, exponent + 64 * static_cast<int>(top - 1));
  }

  /// The same polynomial with the corners in the order (v1, v2, v0) instead of (v0, v1, v2).
  LimbNet turned() const {
    LimbNet result(degree_, width_);
    for (int r = 0; r <= degree_; ++r)
      for (int k = 0; k <= r; ++k)
        std::copy_n(at(lattice_index(r, k)), width_, result.at(lattice_index(degree_ - r + k, degree_ - r)));
    return result;
  }

  /// Every coefficient divided by 2^(64 count), rounded down.
  LimbNet without_lowest(std::size_t count) const {
    LimbNet result(degree_, width_ - count);
    for (int n = 0; n < size(); ++n) std::copy_n(at(n) + count, result.width_, result.at(n));
    return result;
  }

  static Limb sign_limb(Limb top) { return top >> 63 ? ~Limb{0} : Limb{0}; }

 private:
  int degree_;
  std::size_t width_;
  std::vector<Limb> limbs_;
};

/// a += b
inline void add_limbs(Limb* a, const Limb* b, std::size_t width) {
  Limb carry = 0;
  for (std::size_t n = 0; n < width; ++n) {
    const Limb sum = a[n] + b[n];
    const Limb with_carry = sum + carry;
    carry = static_cast<Limb>(sum < b[n]) | static_cast<Limb>(with_carry < sum);
    a[n] = with_carry;
  }
}

/// a <<= bits, 0 <= bits < 64
inline void shift_limbs(Limb* a, std::size_t width, int bits) {
  if (bits == 0) return;
  for (std::size_t n = width; n-- > 1;) a[n] = a[n] << bits | a[n - 1] >> (64 - bits);
  a[0] <<= bits;
}

/// bisect_net without dividing: the coefficients of the halves come out 2^degree times as large. `row` is scratch
/// memory.   Requires    halves that are wide enough for this
inline void bisect_limbs(const LimbNet& net, LimbNet& left, LimbNet& right, std::vector<Limb>& row) {
  const int degree = net.degree();
  const std::size_t width = left.width();
  row.resize(static_cast<std::size_t>(degree + 1) * width);
  const auto in_row = [&](int x) { return row.data() + static_cast<std::size_t>(x) * width; };
  for (int k = 0; k <= degree; ++k) {
    const int n = degree - k;
    for (int t = 0; t <= n; ++t) {
      const Limb* from = net.at(lattice_index(t + k, k));
      Limb* const end = std::copy_n(from, net.width(), in_row(t));
      std::fill(end, in_row(t) + width, LimbNet::sign_limb(from[net.width() - 1]));
    }
    for (int t = 0; t <= n; ++t) {
      Limb* const to_left = left.at(lattice_index(k + t, t));
      Limb* const to_right = right.at(lattice_index(n, t));
      std::copy_n(in_row(0), width, to_left);
      std::copy_n(in_row(n - t), width, to_right);
      shift_limbs(to_left, width, degree - t);
      shift_limbs(to_right, width, degree - t);
      for (int x = 0; x < n - t; ++x) add_limbs(in_row(x), in_row(x + 1), width);
    }
  }
}

}  // namespace pliant
