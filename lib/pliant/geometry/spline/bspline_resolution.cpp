// lib/pliant/geometry/spline/bspline_resolution.cpp: how far a spline may be from the smooth curve that it stands for.
#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/geometry/spline/bspline.h"
#include "pliant/geometry/spline/turning_angle.h"

namespace pliant {
namespace {

/// Favard's constants: splines of degree p with equal spans h interpolate f with an error of at most
/// spline_constants[p] h^(p+1) max |f^(p+1)|.
const std::array<double, max_curve_degree + 1>& spline_constants() {
  static const std::array<double, max_curve_degree + 1> all = [] {
    constexpr double pi = 3.14159265358979323846;
    std::array<double, max_curve_degree + 1> constants{};
    for (int p = 0; p <= max_curve_degree; ++p) {
      const int r = p + 1;
      double sum = 0;
      for (int k = 2000; k >= 0; --k) sum += (k % 2 == 1 && r % 2 == 0 ? -1.0 : 1.0) / std::pow(2 * k + 1, r + 1);
      constants[index(p)] = 4 / pi * sum / std::pow(pi, r);
    }
    return constants;
  }();
  return all;
}

}  // namespace

Vector BSpline::highest_derivative(int k) const {
  const int p = degree_;
  std::array<Vector, max_curve_degree + 1> differences;
  for (int j = 0; j <= p; ++j) differences[index(j)] = point(k - p + j) - point(k - p);
  for (int r = 1; r <= p; ++r)
    for (int j = p; j >= r; --j) {
      const int i = k - p + j;  // control point i has the knots i to i + p + 1 as its support
      differences[index(j)] =
          (p + 1 - r) / (knot(i + p + 1 - r) - knot(i)) * (differences[index(j)] - differences[index(j - 1)]);
    }
  return differences[index(p)];
}

double BSpline::resolution_error(double t0) const {
  const int p = degree_;
  const int k = interval(t0);
  const auto is_span = [&](int i) {
    const bool is_inside = closed_ || (i >= p && i < static_cast<int>(points_.size()));
    return is_inside && knot(i) < knot(i + 1);
  };
  // Two spans on either side, as far as the knots between are simple: elsewhere the curve is meant to be less smooth.
  int first = k, last = k;
  while (first > k - 2 && is_span(first - 1)) --first;
  while (last < k + 2 && is_span(last + 1)) ++last;
  double jumps = 0;
  Vector before = highest_derivative(first);
  for (int i = first + 1; i <= last; ++i) {
    const Vector here = highest_derivative(i);
    jumps += length(here - before);
    before = here;
  }
  const double h = knot(k + 1) - knot(k);
  const double window = (knot(last + 1) + knot(last) - knot(first + 1) - knot(first)) / 2;
  const double constant = spline_constants()[index(p)];
  const double by_jumps = first < last ? constant * std::pow(h, p + 1) * jumps / window : 0;
  if (p == 1) return by_jumps;
  // An arc of a circle has this error. The turning tells it also where a span has no neighbours.
  std::array<Point, max_curve_degree + 1> polygon;
  const std::span<Point> bezier{polygon.data(), index(p + 1)};
  extract(knot(k), bezier);
  return std::max(by_jumps, constant * length(bezier.back() - bezier.front()) * std::pow(turning_angle(bezier), p));
}

}  // namespace pliant
