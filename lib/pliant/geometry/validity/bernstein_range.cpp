// lib/pliant/geometry/validity/bernstein_range.cpp: division of the triangle, the lower piece first.
#include "pliant/geometry/validity/bernstein_range.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/geometry/validity/bisect_net.h"
#include "pliant/geometry/validity/jacobian_enclosure.h"

namespace pliant {
namespace {

/// The error of a coefficient of a piece: it is a mean of means, rounded at most `degree` times in each division.
double error_at(int degree, double error, int depth, double greatest) {
  return error + 2 * depth * degree * unit_roundoff * greatest;
}

double greatest_of(std::span<const double> coefficients) {
  double greatest = 0;
  for (const double c : coefficients) greatest = std::max(greatest, std::fabs(c));
  return greatest;
}

/// A quadratic polynomial on a piece: its coefficients at corners 0 1 2, then those of edges 01, 12, 20.
struct Quadratic {
  std::array<double, 6> c;
  int depth;

  double least() const { return *std::min_element(c.begin(), c.end()); }
  double at_corners() const { return std::min({c[0], c[1], c[2]}); }

  /// Divides the piece along the line from the point at s on edge e to the opposite corner.
  void divide(std::size_t e, double s, Quadratic& first, Quadratic& second) const {
    const std::size_t f = (e + 1) % 3, g = (e + 2) % 3;
    const double left = (1 - s) * c[e] + s * c[3 + e], right = (1 - s) * c[3 + e] + s * c[f];
    const double middle = (1 - s) * left + s * right;
    const double inner = (1 - s) * c[3 + g] + s * c[3 + f];
    first = {{c[e], middle, c[g], left, inner, c[3 + g]}, depth + 1};
    second = {{middle, c[f], c[g], right, c[3 + f], inner}, depth + 1};
  }
};

Bounds enclose_quadratic(std::span<const double> coefficients, double error, double width) {
  constexpr int greatest_depth = 60;
  const double greatest = greatest_of(coefficients);
  std::array<Quadratic, greatest_depth + 2> stack;
  std::copy_n(coefficients.begin(), 6, stack[0].c.begin());
  stack[0].depth = 0;
  double upper = stack[0].at_corners() + error;
  double lower = HUGE_VAL;
  for (std::size_t count = 1; count > 0;) {
    const Quadratic piece = stack[count - 1];
    const double doubt = error_at(2, error, piece.depth, greatest);
    const double least = piece.least() - doubt;
    upper = std::min(upper, piece.at_corners() + doubt);
    // Beyond `greatest_depth` even halves of edges are shorter than roundings of the parameter.
    if (upper - least <= std::max(width, 4 * doubt) || piece.depth == greatest_depth) {
      lower = std::min(lower, least);
      --count;
      continue;
    }
    const auto e = static_cast<std::size_t>(std::min_element(piece.c.begin() + 3, piece.c.end()) - piece.c.begin()) - 3;
    const double a = piece.c[e], m = piece.c[3 + e], b = piece.c[(e + 1) % 3];
    // The least coefficient is that of the edge, so m < a and m < b, and the edge has its minimum inside. Every second
    // division is at the middle instead, because pieces around an inner minimum would shrink in one direction only.
    const double s = piece.depth % 2 == 0 || m >= std::min(a, b) ? (a - m) / ((a - m) + (b - m)) : 0.5;
    Quadratic first, second;
    piece.divide(e, s > 0 && s < 1 ? s : 0.5, first, second);
    const bool swap = first.least() < second.least();  // the lower one is looked at first: it lowers `upper`
    stack[count - 1] = swap ? second : first;
    stack[count] = swap ? first : second;
    ++count;
  }
  return {lower, upper};
}

/// For any degree: by bisection, depth first, the lower half first.
Bounds enclose_by_bisection(int degree, std::span<const double> coefficients, double error, double width) {
  constexpr int greatest_depth = 80;
  constexpr int most_pieces = 20000;
  const double greatest = greatest_of(coefficients);
  const std::size_t size = coefficients.size();
  const std::vector<int>& order = lattice_order(degree);
  const std::array<int, 3> corners = lattice_corners(degree);
  std::vector<double> stack(size * (greatest_depth + 3));
  std::array<int, greatest_depth + 3> depths{};
  std::vector<double> row;
  const auto piece = [&](int n) { return stack.data() + index(n) * size; };
  const auto least_of = [&](int n) { return *std::min_element(piece(n), piece(n) + size); };
  for (std::size_t n = 0; n < size; ++n) stack[index(order[n])] = coefficients[n];
  double upper = HUGE_VAL, lower = HUGE_VAL;
  for (int top = 0, count = 0; top >= 0; ++count) {
    const int depth = depths[index(top)];
    const double doubt = error_at(degree, error, depth, greatest);
    for (const int c : corners) upper = std::min(upper, piece(top)[c] + doubt);
    const double least = least_of(top) - doubt;
    if (upper - least <= std::max(width, 4 * doubt) || depth == greatest_depth || count >= most_pieces) {
      lower = std::min(lower, least);
      --top;
      continue;
    }
    bisect_net<FloatingMean>(degree, piece(top), piece(top + 1), piece(top + 2), row);
    if (least_of(top + 1) < least_of(top + 2)) std::swap_ranges(piece(top + 1), piece(top + 2), piece(top + 2));
    std::copy_n(piece(top + 1), size, piece(top));
    std::copy_n(piece(top + 2), size, piece(top + 1));
    depths[index(top)] = depths[index(top + 1)] = depth + 1;
    ++top;
  }
  return {lower, upper};
}

}  // namespace

Bounds enclose_minimum(int degree, std::span<const double> coefficients, double error, double width) {
  assert(coefficients.size() == index(net_size(degree)));
  const double least = *std::min_element(coefficients.begin(), coefficients.end());
  const double at_corners = degree == 0 ? least : std::min({coefficients[0], coefficients[1], coefficients[2]});
  if (at_corners - least <= width) return {least - error, at_corners + error};
  return degree == 2 ? enclose_quadratic(coefficients, error, width)
                     : enclose_by_bisection(degree, coefficients, error, width);
}

Bounds enclose_maximum(int degree, std::span<const double> coefficients, double error, double width) {
  std::array<double, net_size(2 * (max_degree - 1))> negated;
  for (std::size_t n = 0; n < coefficients.size(); ++n) negated[n] = -coefficients[n];
  const Bounds bounds = enclose_minimum(degree, std::span(negated).first(coefficients.size()), error, width);
  return {-bounds.upper, -bounds.lower};
}

}  // namespace pliant
