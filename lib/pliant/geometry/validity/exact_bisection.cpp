// lib/pliant/geometry/validity/exact_bisection.cpp: the lowest piece is divided next.
#include "pliant/geometry/validity/exact_bisection.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "pliant/geometry/validity/bisect_net.h"

namespace pliant {
namespace {

/// The bits of a coefficient that are kept for bisection: what is rounded away is 2^-448 of the greatest, or less.
constexpr int most_bits = 512;
constexpr double greatest_rounding = 0x1p-440;

struct Piece {
  LimbNet net;
  double least;  // the least coefficient, or 0, in units of the greatest |coefficient| of the whole element
  int corner;    // the forgiven one, if the piece has it
  int depth;
  bool operator<(const Piece& other) const { return least > other.least; }  // the lowest is on top of a heap
};

class Search {
 public:
  Search(LimbNet net, int bits, int corner) : gap_(corner < 0 ? degenerate_gap : degenerate_gap_at_cusp), bits_(bits) {
    assert(bits > 0);
    for (int n = 0; n < net.size(); ++n) unit_ = std::max(unit_, std::fabs(net.value(n, -bits)));
    add({std::move(net), 0, corner, 0});
    if (!pieces_.empty() && bits > most_bits + 63) round_down();
  }

  Certificate run() {
    constexpr int most_bisections = 2048;
    for (int count = 0; !is_negative_ && !pieces_.empty(); ++count) {
      const double least = pieces_.front().least;
      const double enough = gap_ * (1 - 0x1p-40);  // somewhat less than the gap, because values are rounded
      if (least >= -enough && upper_ <= enough) return {Validity::degenerate, gap_};
      if (count == most_bisections) return {Validity::degenerate, std::max(-least, upper_) * (1 + 0x1p-40)};
      bisect_lowest();
    }
    if (is_negative_) return {Validity::invalid, 0};
    if (touches_zero_) return {Validity::degenerate, is_rounded_ ? gap_ : 0};
    return {Validity::valid, 0};
  }

 private:
  /// Coefficient n of a piece, in units of the greatest |coefficient| of the element.
  double value(const Piece& piece, int n) const {
    return piece.net.value(n, -bits_ - piece.depth * piece.net.degree()) / unit_;
  }

  /// Notes what the signs of the coefficients prove, and keeps the piece if they leave anything open. det J > 0 if no
  /// coefficient is negative and those at all three corners are positive, because everywhere the basis function of some
  /// corner is positive. With two positive corners det J > 0 everywhere but at the third one. (A rounded coefficient is
  /// below the true one.)
  void add(Piece piece) {
    bool corners_positive = true;
    const std::array<int, 3> corners = lattice_corners(piece.net.degree());
    for (int c = 0; c < 3; ++c) {
      const int n = corners[static_cast<std::size_t>(c)];
      const double x = value(piece, n);
      is_negative_ = is_negative_ || (is_rounded_ ? x < -greatest_rounding : piece.net.sign(n) < 0);
      if (c == piece.corner) continue;
      upper_ = std::min(upper_, x);
      corners_positive = corners_positive && piece.net.sign(n) > 0;
    }
    bool any_negative = false;
    for (int n = 0; n < piece.net.size(); ++n) {
      if (piece.net.sign(n) >= 0) continue;
      any_negative = true;
      piece.least = std::min(piece.least, value(piece, n));
    }
    touches_zero_ = touches_zero_ || (!any_negative && !corners_positive);
    if (!any_negative) return;
    pieces_.push_back(std::move(piece));
    std::push_heap(pieces_.begin(), pieces_.end());
  }

  void bisect_lowest() {
    std::pop_heap(pieces_.begin(), pieces_.end());
    Piece piece = std::move(pieces_.back());
    pieces_.pop_back();
    // At a forgiven corner every second division halves the angle there: a polynomial that is 0 at the corner and
    // positive in all directions from it has positive coefficients on narrow pieces only.
    for (; piece.corner >= 0 && piece.corner != 2 && piece.depth % 2 == 1; piece.corner = (piece.corner + 2) % 3)
      piece.net = piece.net.turned();
    const int degree = piece.net.degree();
    const int depth = piece.depth + 1;
    const std::size_t width = width_of(bits_ + depth * degree);
    Piece left{LimbNet(degree, width), 0, corner_in_left(piece.corner), depth};
    Piece right{LimbNet(degree, width), 0, corner_in_right(piece.corner), depth};
    bisect_limbs(piece.net, left.net, right.net, row_);
    add(std::move(left));
    add(std::move(right));
  }

  void round_down() {
    const std::size_t count = static_cast<std::size_t>(bits_ - most_bits) / 64;
    pieces_.front().net = pieces_.front().net.without_lowest(count);
    bits_ -= 64 * static_cast<int>(count);
    is_rounded_ = true;
  }

  /// How many limbs hold that many bits and a sign.
  static std::size_t width_of(int bits) { return static_cast<std::size_t>(bits) / 64 + 1; }

  double gap_;
  int bits_;                   // the length of the greatest |coefficient|
  double unit_ = 0;            // the greatest |coefficient| divided by 2^bits_
  double upper_ = HUGE_VAL;    // the least value at a corner
  bool is_negative_ = false;   // det J is negative somewhere
  bool touches_zero_ = false;  // det J may be 0 at a corner of a piece on which it is not negative
  bool is_rounded_ = false;
  std::vector<Piece> pieces_;  // those with a negative coefficient
  std::vector<Limb> row_;
};

}  // namespace

Certificate certify_by_bisection(LimbNet net, int bits, int corner) {
  return Search(std::move(net), bits, corner).run();
}

}  // namespace pliant
