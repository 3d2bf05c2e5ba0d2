// lib/pliant/ops/removal/removal_stretch.cpp: Newton's steps along the gradient of the swept area.
#include "pliant/ops/removal/removal_stretch.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// Calls `visit` with k and the index of control point first + k, for k = 0 .. count - 1. On a closed curve indices go
/// round; on an open one points that do not exist are left out.
template <class Visit>
void visit_points(const BSpline& spline, int first, int count, const Visit& visit) {
  const int size = static_cast<int>(spline.points().size());
  for (int k = 0; k < count; ++k) {
    const int i = first + k;
    if (spline.closed())
      visit(k, (i % size + size) % size);
    else if (0 <= i && i < size)
      visit(k, i);
  }
}

/// So many control points before and behind number interval(knot), a removal and what restores the area may move.
int reach(const BSpline& spline) { return 2 * spline.degree() + 1; }

}  // namespace

RemovalStretch::RemovalStretch(const Mesh& mesh, CurveId curve, double knot)
    : curve_(curve), knot_(knot), multiplicity_(mesh.spline(curve).multiplicity(knot)) {
  const BSpline& spline = mesh.spline(curve);
  origin_ = spline.evaluate(knot);
  const int spans = std::max(spline.degree(), 2);  // so many on either side may change
  const auto is_new = [&](double t) {
    return t != knot && std::find(starts_.begin(), starts_.end(), t) == starts_.end();
  };
  double t = knot;
  for (int k = 0; k < spans && (spline.closed() || t > spline.first_parameter()); ++k) {
    t = spline.span_before(t);
    if (!is_new(t)) break;
    starts_.push_back(t);
  }
  t = knot;
  for (int k = 1; k < spans; ++k) {
    t = spline.span_end(t);
    if (t >= spline.last_parameter()) {
      if (!spline.closed()) break;
      t = spline.first_parameter();
    }
    if (!is_new(t)) break;
    starts_.push_back(t);
  }
  area_ = area(spline) + spline.swept_area(knot, origin_);
  points_.resize(index(2 * reach(spline) + 1));
  visit_points(spline, spline.interval(knot) - reach(spline), 2 * reach(spline) + 1,
               [&](int k, int i) { points_[index(k)] = spline.points()[index(i)]; });
}

double RemovalStretch::area(const BSpline& spline) const {
  double sum = 0;
  for (const double start : starts_) sum += spline.swept_area(start, origin_);
  return sum;
}

std::vector<int> RemovalStretch::points_around(const BSpline& spline, double place) const {
  // The points whose support contains the removed knot even without its first and last span (p = 1: with them). What
  // they change does not reach beyond the footprint. The ends of an open curve stay.
  const int last = static_cast<int>(spline.points().size()) - 1, p = spline.degree(), inset = p > 1 ? 1 : 0;
  const int first = spline.interval(place) - p;
  std::vector<int> near;
  visit_points(spline, first, p + 1, [&](int k, int i) {
    if (!spline.closed() && (i == 0 || i == last)) return;
    if (!(spline.knot(first + k + inset) < place && place < spline.knot(first + k + p + 1 - inset))) return;
    if (std::find(near.begin(), near.end(), i) == near.end()) near.push_back(i);
  });
  return near;
}

double RemovalStretch::restore_area(Mesh& mesh) const {
  const BSpline& spline = mesh.spline(curve_);
  // A closed curve that lost its first break begins at the next one.
  const double place = knot_ < spline.first_parameter() ? knot_ + spline.period() : knot_;
  const std::vector<int> near = points_around(spline, place);
  // The area is quadratic in the points, so central differences give its gradient exactly, whatever the step.
  Box box;
  visit_points(spline, spline.interval(place) - reach(spline), 2 * reach(spline) + 1,
               [&](int, int i) { box.extend(spline.points()[index(i)]); });
  const double step = std::ldexp(1.0, std::ilogb(box.size()));
  const auto area_with = [&](int k, const Point& there) {
    const Point kept = spline.points()[index(k)];
    mesh.set_curve_point(curve_, k, there);
    const double area = this->area(spline);
    mesh.set_curve_point(curve_, k, kept);
    return area;
  };
  double squares = 0;
  std::vector<Vector> gradient;
  for (const int k : near) {
    const Point p0 = spline.points()[index(k)];
    gradient.push_back({(area_with(k, p0 + Vector{step, 0}) - area_with(k, p0 - Vector{step, 0})) / (2 * step),
                        (area_with(k, p0 + Vector{0, step}) - area_with(k, p0 - Vector{0, step})) / (2 * step)});
    squares += squared_length(gradient.back());
  }
  double last = HUGE_VAL;
  // Each round leaves a small share of what was missing, until only rounding is left.
  for (int round = 0; round < 60 && squares > 0; ++round) {
    const double missing = area_ - area(spline);
    if (!(std::abs(missing) < last)) break;
    last = std::abs(missing);
    for (std::size_t k = 0; k < near.size(); ++k)
      mesh.set_curve_point(curve_, near[k], spline.points()[index(near[k])] + (missing / squares) * gradient[k]);
  }
  if (last > 0.1 * box.tolerance() * box.size()) return HUGE_VAL;  // too much is missing for small steps
  return distance_to(mesh, place);
}

double RemovalStretch::distance_to(Mesh& mesh, double place) const {
  const BSpline& spline = mesh.spline(curve_);
  Transaction trial(mesh);  // rolled back at the end
  for (int m = multiplicity_; m > 0; --m) mesh.insert_knot(curve_, place);
  double error = 0;
  visit_points(spline, spline.interval(place) - reach(spline), 2 * reach(spline) + 1,
               [&](int k, int i) { error = std::max(error, distance(points_[index(k)], spline.points()[index(i)])); });
  return error;
}

}  // namespace pliant
