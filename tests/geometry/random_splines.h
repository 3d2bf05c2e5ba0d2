// tests/geometry/random_splines.h: random B-splines of every degree, open and closed, with knots of any multiplicity.
#pragma once
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "pliant/geometry/spline/bspline.h"

namespace pliant::samples {

/// A curve with 1 to 8 spans of unequal length, random points and repeated knots (on a closed curve also at the seam).
inline BSpline random_curve(int degree, bool closed, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto up_to = [&random](int n) { return 1 + static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<double> breaks{3 * unit(random) - 1};
  for (int i = closed ? std::max(3, degree) : up_to(8); i > 0; --i)
    breaks.push_back(breaks.back() + 0.05 + unit(random));
  std::vector<double> knots;
  const auto repeat = [&knots](double t, int times) { knots.insert(knots.end(), static_cast<std::size_t>(times), t); };
  const int seam = up_to(degree), at_start = up_to(seam);
  repeat(breaks.front(), closed ? at_start : degree + 1);
  for (std::size_t i = 1; i + 1 < breaks.size(); ++i) repeat(breaks[i], unit(random) < 0.5 ? 1 : up_to(degree));
  repeat(breaks.back(), closed ? seam - at_start + 1 : degree + 1);
  const std::size_t count = closed ? knots.size() - 1 : knots.size() - static_cast<std::size_t>(degree) - 1;
  std::vector<Point> points(count);
  for (Point& p : points) p = {unit(random), unit(random)};
  REQUIRE_FALSE(BSpline::fault(degree, closed, knots, points));
  return BSpline(degree, closed, knots, points);
}

inline std::vector<double> parameters(const BSpline& curve, int steps = 60) {
  std::vector<double> all = curve.breaks();
  for (int i = 1; i < steps; ++i) all.push_back(curve.first_parameter() + curve.period() * i / steps);
  return all;
}

inline double greatest_distance(const BSpline& a, const BSpline& b) {
  double most = 0;
  for (const double t : parameters(a)) most = std::max(most, distance(a.evaluate(t), b.evaluate(t)));
  return most;
}

inline const BSpline unit_square(1, true, {0, 1, 2, 3, 4}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});

}  // namespace pliant::samples

/// Runs what stands between the two macros for 600 curves named `curve`, of `degree` 1 to 5, `closed` or not.
#define EVERY_CURVE                            \
  const int degree = GENERATE(1, 2, 3, 4, 5);  \
  const bool closed = GENERATE(false, true);   \
  for (unsigned seed = 0; seed < 60; ++seed) { \
    CAPTURE(degree, closed, seed);             \
    const BSpline curve = random_curve(degree, closed, seed);
#define END_EVERY_CURVE }
