// lib/pliant/flow/move_curves.cpp: the boundary complex carried along as splines (paper §6; design: Motion).
#include "pliant/flow/move_curves.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

/// The spline on the same knots whose value at each Greville abscissa is the vector given; empty if singular.
bool interpolate_vectors(const BSpline& shape, std::span<const Vector> values, BSpline& vectors) {
  vectors = shape;
  return vectors.interpolate(values);
}

void add(BSpline& spline, const BSpline& vectors, double factor) {
  for (std::size_t i = 0; i < spline.points().size(); ++i)
    spline.set_point(static_cast<int>(i), spline.points()[i] + factor * vectors.points()[i]);
}

/// Offsets a closed curve along its normals until it encloses `area`; the length of the offset, 0 if there is none.
///
/// Control points move linearly with the offset, so the area is a quadratic polynomial of it; Newton's steps take the
/// derivative by polarization and end at rounding.
double restore_area(BSpline& spline, double area) {
  Box box;
  for (const Point& p : spline.points()) box.extend(p);
  if (!(box.size() > 0)) return 0;
  // Offsets are counted in a unit of the curve's size, so that the scale of the mesh does not matter.
  const double unit = std::ldexp(1.0, std::ilogb(box.size()));
  std::vector<Vector> normals;
  for (const double g : spline.greville()) {
    const Vector along = spline.derivative(g);
    const double speed = length(along);
    if (!(speed > 0)) return 0;
    normals.push_back(-(unit / speed) * perpendicular(along));
  }
  BSpline direction;
  if (!interpolate_vectors(spline, normals, direction)) return 0;
  const BSpline before = spline;
  BSpline sum = spline;
  add(sum, direction, 1);
  const double second = direction.area();
  const double first = sum.area() - spline.area() - second;
  double offset = 0;
  double miss = area - spline.area();
  for (int step = 0; step < 6; ++step) {
    const double slope = first + 2 * second * offset;
    // A slope this small belongs to a curve without an inside to speak of: no offset would help.
    if (!(std::abs(slope) * std::abs(slope) > 4 * std::abs(second * miss))) break;
    const double next = offset + miss / slope;
    BSpline trial = before;
    add(trial, direction, next);
    const double next_miss = area - trial.area();
    if (!(std::abs(next_miss) < std::abs(miss))) break;
    offset = next;
    miss = next_miss;
    spline = std::move(trial);
  }
  return offset * unit;
}

}  // namespace

MovedBoundary move_curves(const BoundaryComplex& boundary, const BoundaryDisplacement& displacement, bool keep_area) {
  MovedBoundary moved;
  std::vector<Vector> by_vertex;
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v) {
    by_vertex.push_back(displacement.at_vertex(static_cast<int>(v)));
    moved.vertices.push_back(boundary.vertices[v] + by_vertex.back());
    if (!is_finite(moved.vertices.back())) moved.status = MovedBoundary::Status::not_finite;
  }
  if (moved.status != MovedBoundary::Status::done) return moved;

  std::vector<Vector> values;
  for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
    const Curve& curve = boundary.curves[c];
    moved.place = static_cast<int>(c);
    const std::vector<double> greville = curve.spline.greville();
    values.assign(greville.size(), {});
    for (std::size_t i = 0; i < greville.size(); ++i) {
      // Ends are vertices: the mean of equal knots may be off by a bit, and corners must stay shared.
      if (!curve.spline.closed() && i == 0)
        values[i] = by_vertex[static_cast<std::size_t>(curve.start)];
      else if (!curve.spline.closed() && i + 1 == greville.size())
        values[i] = by_vertex[static_cast<std::size_t>(curve.end)];
      else
        values[i] = displacement.on_curve(static_cast<int>(c), greville[i]);
      if (!is_finite(values[i])) moved.status = MovedBoundary::Status::not_finite;
    }
    if (moved.status != MovedBoundary::Status::done) return moved;
    BSpline spline = curve.spline;
    BSpline vectors;
    if (!interpolate_vectors(spline, values, vectors)) {
      moved.status = MovedBoundary::Status::not_interpolable;
      return moved;
    }
    add(spline, vectors, 1);
    if (!spline.closed()) {
      spline.set_point(0, moved.vertices[static_cast<std::size_t>(curve.start)]);
      spline.set_point(static_cast<int>(spline.points().size()) - 1,
                       moved.vertices[static_cast<std::size_t>(curve.end)]);
    } else if (keep_area) {
      moved.area_offset = std::max(moved.area_offset, std::abs(restore_area(spline, curve.spline.area())));
    }
    if (!std::ranges::all_of(spline.points(), is_finite)) {
      moved.status = MovedBoundary::Status::not_finite;
      return moved;
    }
    moved.splines.push_back(std::move(spline));
  }
  moved.place = -1;
  return moved;
}

}  // namespace pliant
