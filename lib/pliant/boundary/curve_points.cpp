// lib/pliant/boundary/curve_points.cpp: de Casteljau and blossoms; Gauss-Newton; roots by the variation of signs.
#include "pliant/boundary/curve_points.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "pliant/geometry/spline/bspline.h"

namespace pliant {
namespace {

using Polygon = std::array<Point, max_curve_degree + 1>;

/// Appends the roots in (from, to) of the polynomial that has the Bernstein coefficients c on this interval.
void append_roots(std::vector<double> c, double from, double to, int depth, std::vector<double>& roots) {
  int changes = 0;
  double sign = 0;
  for (const double v : c) {
    if (v == 0) continue;
    changes += sign * v < 0;
    sign = v > 0 ? 1 : -1;
  }
  if (changes == 0 && !(c.front() == 0 && depth > 0)) return;
  const double middle = from + (to - from) / 2;
  if (depth > 52 || middle <= from || middle >= to) return roots.push_back(middle);
  if (changes == 0) return roots.push_back(from);  // a zero at a cut between halves
  std::vector<double> left(c.size());
  for (std::size_t r = 0; r < c.size(); ++r) {
    left[r] = c[0];
    for (std::size_t i = 0; i + r + 1 < c.size(); ++i) c[i] = 0.5 * (c[i] + c[i + 1]);
  }
  // c holds the coefficients of the right half now.
  append_roots(std::move(left), from, middle, depth + 1, roots);
  append_roots(std::move(c), middle, to, depth + 1, roots);
}

}  // namespace

CurveJet bezier_jet(std::span<const Point> polygon, double t) {
  const auto p = polygon.size() - 1;
  Polygon work;
  std::copy(polygon.begin(), polygon.end(), work.begin());
  for (std::size_t r = 0; r + 1 < p; ++r)
    for (std::size_t i = 0; i < p - r; ++i) work[i] = (1 - t) * work[i] + t * work[i + 1];
  return {(1 - t) * work[0] + t * work[1], static_cast<double>(p) * (work[1] - work[0])};
}

Point bezier_point(std::span<const Point> polygon, double t) { return bezier_jet(polygon, t).value; }

void bezier_part(std::span<const Point> polygon, double t0, double t1, std::span<Point> out) {
  const auto p = polygon.size() - 1;
  assert(out.size() == polygon.size());
  if (t0 == 0 && t1 == 1) {
    std::copy(polygon.begin(), polygon.end(), out.begin());
  } else if (t0 == 1 && t1 == 0) {
    std::reverse_copy(polygon.begin(), polygon.end(), out.begin());
  } else {
    Polygon work;
    for (std::size_t k = 0; k <= p; ++k) {  // the blossom with t0 as p - k of its arguments and t1 as k of them
      std::copy(polygon.begin(), polygon.end(), work.begin());
      for (std::size_t r = 0; r < p; ++r) {
        const double t = r < k ? t1 : t0;
        for (std::size_t i = 0; i < p - r; ++i) work[i] = (1 - t) * work[i] + t * work[i + 1];
      }
      out[k] = work[0];
    }
  }
}

Nearest nearest_on_curve(std::span<const Point> polygon, const Point& p) {
  const int samples = 2 * static_cast<int>(polygon.size());
  double best = 0, least = HUGE_VAL;
  const auto try_at = [&](double t) {
    const double d = squared_length(bezier_point(polygon, t) - p);
    if (!(d < least)) return false;
    best = t;
    least = d;
    return true;
  };
  for (int i = 0; i <= samples; ++i) try_at(static_cast<double>(i) / samples);
  // Gauss-Newton steps on the distance, which converge fast where it is small. Steps that do not come nearer are
  // halved.
  for (int step = 0; step < 30; ++step) {
    const CurveJet jet = bezier_jet(polygon, best);
    const double speed = squared_length(jet.derivative);
    if (!(speed > 0)) break;
    double by = dot(p - jet.value, jet.derivative) / speed;
    bool nearer = false;
    for (int halving = 0; halving < 5 && !nearer; ++halving, by /= 2) nearer = try_at(std::clamp(best + by, 0.0, 1.0));
    if (!nearer) break;
  }
  return {best, std::sqrt(least)};
}

std::vector<double> monotone_cuts(std::span<const Point> polygon, double least) {
  const std::size_t p = polygon.size() - 1;
  std::vector<double> roots;
  for (const double Point::*axis : {&Point::x, &Point::y}) {
    std::vector<double> legs(p);
    for (std::size_t i = 0; i < p; ++i) {
      legs[i] = polygon[i + 1].*axis - polygon[i].*axis;
      if (std::fabs(legs[i]) <= least / 16) legs[i] = 0;
    }
    append_roots(std::move(legs), 0, 1, 0, roots);
  }
  std::sort(roots.begin(), roots.end());
  std::vector<double> cuts;
  Polygon part;
  const auto extent = [&](double t0, double t1) {
    bezier_part(polygon, t0, t1, std::span<Point>(part).first(p + 1));
    Box box;
    for (std::size_t i = 0; i <= p; ++i) box.extend(part[i]);
    return box.size();
  };
  for (const double t : roots)
    if (0 < t && t < 1 && extent(cuts.empty() ? 0 : cuts.back(), t) > least && extent(t, 1) > least) cuts.push_back(t);
  return cuts;
}

}  // namespace pliant
