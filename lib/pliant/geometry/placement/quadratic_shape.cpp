// lib/pliant/geometry/placement/quadratic_shape.cpp: the least ratio of two quadratic forms, by Dinkelbach's method.
#include "pliant/geometry/placement/quadratic_shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pliant {
namespace {

constexpr int most_steps = 30;             // never reached: convergence is quadratic, and the loop ends by itself
constexpr double rounding = 0x1p-53 * 64;  // the error of `least_value`, relative to the greatest entry
constexpr double flat = 1e-14;             // a form this flat in some direction is taken to be least on the boundary

struct LeastValue {
  double value;
  Barycentric at;
};

/// The least value of a form on the triangle, within `rounding` of its greatest entry: at a corner, or where it is
/// stationary on an edge or inside.
LeastValue least_value(const QuadraticForm& m) {
  const std::size_t c = m[0] <= m[1] ? (m[0] <= m[2] ? 0 : 2) : (m[1] <= m[2] ? 1 : 2);
  LeastValue best{m[c], {}};
  best.at[c] = 1;
  if (std::min({m[3], m[4], m[5]}) >= m[c]) return best;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = i == 2 ? 0 : i + 1;
    const double fall_i = m[i] - m[3 + i], fall_j = m[j] - m[3 + i];
    if (!(fall_i > 0 && fall_j > 0)) continue;
    const double share = fall_i / (fall_i + fall_j);
    if (const double value = m[i] - fall_i * share; value < best.value) {
      best = {value, {}};
      best.at[i] = 1 - share;
      best.at[j] = share;
    }
  }
  const double d2 = m[0] - m[3], d3 = m[0] - m[5];
  const double h22 = d2 + (m[1] - m[3]), h33 = d3 + (m[2] - m[5]), h23 = d2 + (m[4] - m[5]);
  const double determinant = h22 * h33 - h23 * h23;
  if (!(h22 > 0 && determinant > flat * h22 * h33)) return best;
  const double y = (d2 * h33 - d3 * h23) / determinant, z = (h22 * d3 - h23 * d2) / determinant;
  if (!(y > 0 && z > 0 && y + z < 1)) return best;
  if (const double value = m[0] - d2 * y - d3 * z; value < best.value) best = {value, {1 - y - z, y, z}};
  return best;
}

double value_at(const QuadraticForm& m, const Barycentric& x) {
  return x[0] * (m[0] * x[0] + 2 * m[3] * x[1]) + x[1] * (m[1] * x[1] + 2 * m[4] * x[2]) +
         x[2] * (m[2] * x[2] + 2 * m[5] * x[0]);
}

double greatest_entry(const QuadraticForm& m) {
  double greatest = 0;
  for (const double entry : m) greatest = std::max(greatest, std::fabs(entry));
  return greatest;
}

}  // namespace

ShapeBounds least_ratio(const QuadraticForm& numerator, const QuadraticForm& denominator, double error) {
  ShapeBounds bounds{-1, std::numeric_limits<double>::infinity(), {}};
  for (std::size_t c = 0; c < 3; ++c) {
    const double ratio = denominator[c] > 0 ? numerator[c] / denominator[c] : 0;
    if (!(ratio < bounds.upper)) continue;
    bounds.upper = ratio;
    bounds.worst = {};
    bounds.worst[c] = 1;
  }
  const double greatest = greatest_entry(numerator), greatest_below = greatest_entry(denominator);
  double least = 0, guard = 0;
  for (int steps = 0; steps < most_steps; ++steps) {
    QuadraticForm m;
    for (std::size_t n = 0; n < 6; ++n) m[n] = numerator[n] - bounds.upper * denominator[n];
    const LeastValue lowest = least_value(m);
    least = lowest.value;
    guard = rounding * (greatest + std::fabs(bounds.upper) * greatest_below) + error * (1 + std::fabs(bounds.upper));
    if (least >= -guard) break;
    const double below = value_at(denominator, lowest.at);
    const double ratio = below > 0 ? std::max(-1.0, value_at(numerator, lowest.at) / below) : 0;
    if (!(ratio < bounds.upper)) break;
    bounds.upper = ratio;
    bounds.worst = lowest.at;
  }
  // The ratio is nowhere less than t - width if numerator - (t - width) denominator is positive everywhere. The width
  // that suffices at the worst place is tried first.
  const double there = value_at(denominator, bounds.worst);
  const double width = there > 0 ? 3 * guard / there : 0;
  if (QuadraticForm m; least >= -guard && width > 0) {
    for (std::size_t n = 0; n < 6; ++n) m[n] = numerator[n] - (bounds.upper - width) * denominator[n];
    if (least_value(m).value >= guard) {
      bounds.lower = std::max(-1.0, bounds.upper - width);
      return bounds;
    }
  }
  double least_below = *std::min_element(denominator.begin(), denominator.end());
  if (least_below < 0.01 * greatest_below) least_below = least_value(denominator).value;
  least_below -= rounding * greatest_below + error;
  if (least_below > 0) bounds.lower = std::max(-1.0, bounds.upper + std::min(0.0, least - guard) / least_below);
  return bounds;
}

}  // namespace pliant
