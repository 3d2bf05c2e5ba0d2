#include <algorithm>  // lib/pliant/geometry/jacobian_range.cpp: enclosures of the extrema of det J, by bisection
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

#include "pliant/geometry/bisect_net.h"
#include "pliant/geometry/jacobian_enclosure.h"
#include "pliant/geometry/validity.h"

namespace pliant {
namespace {

constexpr std::size_t at(int n) { return static_cast<std::size_t>(n); }

/// x * 2^exponent, rounded down (towards minus infinity).
double scale_down(double x, int exponent) {
  const double result = std::ldexp(x, exponent);
  const bool is_exact = std::isfinite(result) && std::ldexp(result, -exponent) == x;
  return is_exact ? result : std::nextafter(result, -HUGE_VAL);
}

/// An enclosure of the minimum of `sign` * det J, by bisecting the piece with the least coefficient.
Bounds enclose_minimum(const JacobianEnclosure& jacobian, double sign, double relative_width) {
  struct Piece {
    double least;
    int depth;
    std::vector<double> coefficients;
    bool operator<(const Piece& other) const { return least > other.least; }
  };
  constexpr int greatest_depth = 80;
  constexpr int most_pieces = 20000;
  const int degree = jacobian.degree;
  const std::array<int, 3> corners = lattice_corners(degree);
  double upper = HUGE_VAL;
  std::priority_queue<Piece> pieces;
  const auto add = [&](std::vector<double> coefficients, int depth) {
    const double error = jacobian.error_at(depth);
    for (const int c : corners) upper = std::min(upper, coefficients[at(c)] + error);
    const double least = *std::min_element(coefficients.begin(), coefficients.end()) - error;
    pieces.push({least, depth, std::move(coefficients)});
  };
  std::vector<double> whole;
  for (int n = 0; n < net_size(degree); ++n) whole.push_back(sign * jacobian.coefficients[at(n)]);
  add(std::move(whole), 0);
  std::vector<double> row;
  for (int count = 0; count < most_pieces; ++count) {
    const Piece& worst = pieces.top();
    const double finest = 4 * jacobian.error_at(worst.depth);
    if (upper - worst.least <= std::max(relative_width * jacobian.greatest, finest) || worst.depth == greatest_depth)
      break;
    const int depth = worst.depth + 1;
    std::vector<double> left(worst.coefficients.size());
    std::vector<double> right(worst.coefficients.size());
    bisect_net<FloatingMean>(degree, worst.coefficients.data(), left.data(), right.data(), row);
    pieces.pop();
    add(std::move(left), depth);
    add(std::move(right), depth);
  }
  return {scale_down(pieces.top().least, jacobian.exponent), -scale_down(-upper, jacobian.exponent)};
}

}  // namespace

JacobianRange jacobian_range(int degree, std::span<const Point> net, double relative_width) {
  assert(1 <= degree && degree <= max_degree && net.size() >= at(net_size(degree)));
  JacobianEnclosure jacobian;
  enclose_jacobian(degree, net, jacobian);
  if (!jacobian.is_finite) return {{-HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, HUGE_VAL}};
  const Bounds least = enclose_minimum(jacobian, 1, relative_width);
  const Bounds negated = enclose_minimum(jacobian, -1, relative_width);
  return {least, {-negated.upper, -negated.lower}};
}

}  // namespace pliant
