// tests/support/cut_polygon.h: the least value of a convex function, by cutting polygons in two, in long double.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace pliant::samples {

using Real = long double;
struct Place {
  Real x, y;
};

/// The cost of a place q, with a lower bound everywhere: cost(q') >= cost + slope . (q' - q). If q is not allowed, no
/// place q' with cost + slope . (q' - q) > 0 is allowed either.
struct Cost {
  Real cost;
  Place slope;
  bool is_allowed = true;
};

struct LeastCost {
  Real cost, sure;  ///< the least cost that was found; no cost is below `sure`
  Place place;
  bool is_found;
};

/// Minimises a convex function over a square. The polygon that may contain the best place is cut at its centre of
/// gravity, again and again, until the bound is within `width` of the best cost.
template <class CostAt>
LeastCost least_cost(const Place& middle, Real half, Real width, CostAt cost_at) {
  static constexpr Real infinity = std::numeric_limits<Real>::infinity();
  std::vector<Place> polygon{{middle.x - half, middle.y - half},
                             {middle.x + half, middle.y - half},
                             {middle.x + half, middle.y + half},
                             {middle.x - half, middle.y + half}},
      rest;
  std::vector<Real> excess;
  LeastCost best{infinity, -infinity, middle, false};
  Place q = middle;
  for (int steps = 0; steps < 400; ++steps) {
    const Cost at = cost_at(q);
    if (at.is_allowed && at.cost < best.cost) best = {at.cost, best.sure, q, true};
    const Real bound = at.is_allowed ? best.cost : 0;
    Real least = infinity;
    excess.clear();
    for (const Place& v : polygon) {
      const Real promise = at.cost + at.slope.x * (v.x - q.x) + at.slope.y * (v.y - q.y);
      least = std::min(least, promise);
      excess.push_back(promise - bound);
    }
    if (at.is_allowed) best.sure = std::max(best.sure, std::min(best.cost, least));
    if (best.is_found && best.cost - best.sure <= width * std::max(Real{1}, std::fabs(best.cost))) break;
    rest.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t j = (i + 1) % polygon.size();
      if (excess[i] <= 0) rest.push_back(polygon[i]);
      if ((excess[i] < 0) == (excess[j] < 0) || excess[i] == 0 || excess[j] == 0) continue;
      const Real s = excess[i] / (excess[i] - excess[j]);
      rest.push_back(
          {polygon[i].x + s * (polygon[j].x - polygon[i].x), polygon[i].y + s * (polygon[j].y - polygon[i].y)});
    }
    std::swap(polygon, rest);
    if (polygon.size() < 3) break;
    Real area = 0;
    Place moment{0, 0};
    const Place& o = polygon[0];
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      const Place a{polygon[i].x - o.x, polygon[i].y - o.y}, b{polygon[i + 1].x - o.x, polygon[i + 1].y - o.y};
      const Real twice = a.x * b.y - a.y * b.x;
      area += twice;
      moment.x += twice * (a.x + b.x) / 3;
      moment.y += twice * (a.y + b.y) / 3;
    }
    if (!(area > 1e-36L * half * half)) break;
    q = {o.x + moment.x / area, o.y + moment.y / area};
  }
  return best;
}

}  // namespace pliant::samples
