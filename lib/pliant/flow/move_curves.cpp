// lib/pliant/flow/move_curves.cpp: adds to each spline the spline that interpolates its displacement.
#include "pliant/flow/move_curves.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/spline/restore_area.h"

namespace pliant {

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
      // The ends of an open curve move with their vertices, since corners must stay shared. (The Greville abscissa
      // there, a mean of equal knots, may be off by a bit.)
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
    BSpline vectors = spline;
    if (!vectors.interpolate(values)) {
      moved.status = MovedBoundary::Status::not_interpolable;
      return moved;
    }
    spline.add(vectors, 1);
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
