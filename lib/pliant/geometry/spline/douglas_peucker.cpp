// lib/pliant/geometry/spline/douglas_peucker.cpp: stretches of a polyline, divided where they are farthest off.
#include "pliant/geometry/spline/douglas_peucker.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace pliant {
namespace {

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Vector chord = b - a;
  const double square = squared_length(chord);
  const double s = square > 0 ? std::clamp(dot(p - a, chord) / square, 0.0, 1.0) : 0;
  return distance(p, a + s * chord);
}

std::size_t farthest_from(std::span<const Point> points, std::size_t from) {
  std::size_t best = from;
  double most = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const double d = distance(points[i], points[from]); d > most) {
      most = d;
      best = i;
    }
  return best;
}

}  // namespace

std::vector<bool> douglas_peucker(std::span<const Point> polyline, bool closed, double tolerance) {
  const std::size_t n = polyline.size();
  std::vector<bool> kept(n, false);
  if (n == 0) return kept;

  // The stretches that are still to be looked at. On a closed polyline, index n + i stands for point i.
  std::vector<std::pair<std::size_t, std::size_t>> stretches;
  if (closed) {
    const std::size_t a = farthest_from(polyline, 0), b = farthest_from(polyline, a);
    kept[a] = kept[b] = true;
    const auto [low, high] = std::minmax(a, b);
    stretches = {{low, high}, {high, low + n}};
  } else {
    kept.front() = kept.back() = true;
    stretches = {{0, n - 1}};
  }
  while (!stretches.empty()) {
    const auto [from, to] = stretches.back();
    stretches.pop_back();
    std::size_t worst = from;
    double most = tolerance;
    for (std::size_t i = from + 1; i < to; ++i)
      if (const double d = distance_to_segment(polyline[i % n], polyline[from % n], polyline[to % n]); d > most) {
        most = d;
        worst = i;
      }
    if (worst == from) continue;
    kept[worst % n] = true;
    stretches.emplace_back(from, worst);
    stretches.emplace_back(worst, to);
  }
  return kept;
}

}  // namespace pliant
