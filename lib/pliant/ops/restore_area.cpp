#include "pliant/ops/restore_area.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pliant {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

double restore_area(const BSpline& old, BSpline& spline, double knot) {
  // The points whose inner knots straddle the removed one (p = 1: whose support does): none of them reaches beyond the
  // footprint. An open curve's ends stay.
  const int count = static_cast<int>(spline.points().size()), p = spline.degree(), inset = p > 1 ? 1 : 0;
  std::vector<int> near;
  for (int i = spline.closed() ? 0 : 1; i < (spline.closed() ? count : count - 1); ++i)
    for (const double turn : {0.0, spline.closed() ? spline.period() : 0.0}) {
      const double t = knot + turn;
      if (spline.knot(i + inset) < t && t < spline.knot(i + p + 1 - inset)) {
        near.push_back(i);
        break;
      }
    }
  // The area is quadratic in the points, so central differences are its gradient, whatever the step.
  Box box;
  for (const Point& point : old.points()) box.extend(point);
  const Point origin = old.points().front();
  const double step = std::ldexp(1.0, std::ilogb(box.size()));
  const auto area_with = [&](int k, const Point& place) {
    const Point kept = spline.points()[at(k)];
    spline.set_point(k, place);
    const double area = spline.area(origin);
    spline.set_point(k, kept);
    return area;
  };
  double squares = 0;
  std::vector<Vector> gradient;
  for (const int k : near) {
    const Point p0 = spline.points()[at(k)];
    gradient.push_back({(area_with(k, p0 + Vector{step, 0}) - area_with(k, p0 - Vector{step, 0})) / (2 * step),
                        (area_with(k, p0 + Vector{0, step}) - area_with(k, p0 - Vector{0, step})) / (2 * step)});
    squares += squared_length(gradient.back());
  }
  const double wanted = old.area(origin);
  double last = HUGE_VAL;
  for (int round = 0; round < 60 && squares > 0;
       ++round) {  // each leaves a small share of the rest, then only rounding
    const double missing = wanted - spline.area(origin);
    if (!(std::abs(missing) < last)) break;
    last = std::abs(missing);
    for (std::size_t k = 0; k < near.size(); ++k)
      spline.set_point(near[k], spline.points()[at(near[k])] + (missing / squares) * gradient[k]);
  }
  if (last > 0.1 * box.tolerance() * box.size()) return HUGE_VAL;  // too much is missing for small steps
  BSpline again = spline;
  const double place = knot < again.first_parameter() ? knot + again.period() : knot;  // the first break is gone
  for (int m = old.multiplicity(knot); m > 0; --m) again.insert_knot(place);
  // A closed curve that loses its first break starts at the next one: its points are then one place further.
  std::size_t shift = 0;
  while (old.closed() && shift + 1 < old.points().size() && old.knot(static_cast<int>(shift)) < again.knot(0)) ++shift;
  double error = 0;
  for (std::size_t k = 0; k < old.points().size(); ++k)
    error = std::max(error, distance(old.points()[(k + shift) % old.points().size()], again.points()[k]));
  return error;
}

}  // namespace pliant
