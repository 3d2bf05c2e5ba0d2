// lib/pliant/flow/move_curves.cpp: adds to each spline the spline that interpolates its displacement.
#include "pliant/flow/move_curves.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/spline/restore_area.h"

namespace pliant {

void BoundaryDisplacements::join_ends(const Curve& curve, std::size_t number) {
  if (curve.spline.closed()) return;
  at_greville[number].front() = at_vertex[static_cast<std::size_t>(curve.start)];
  at_greville[number].back() = at_vertex[static_cast<std::size_t>(curve.end)];
}

BoundaryDisplacements sample_displacements(const BoundaryComplex& boundary, const BoundaryDisplacement& displacement) {
  BoundaryDisplacements all;
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v) {
    all.at_vertex.push_back(displacement.at_vertex(static_cast<int>(v)));
    if (!is_finite(boundary.vertices[v] + all.at_vertex.back())) all.not_finite = -1;
  }
  for (std::size_t c = 0; c < boundary.curves.size() && all.not_finite == -2; ++c) {
    const Curve& curve = boundary.curves[c];
    const std::vector<double> greville = curve.spline.greville();
    std::vector<Vector>& values = all.at_greville.emplace_back(greville.size());
    for (std::size_t i = 0; i < greville.size(); ++i)
      // The Greville abscissa at the end of an open curve, a mean of equal knots, may be off by a bit.
      if (curve.spline.closed() || (i > 0 && i + 1 < greville.size()))
        values[i] = displacement.on_curve(static_cast<int>(c), greville[i]);
    all.join_ends(curve, c);
    if (!std::ranges::all_of(values, is_finite)) all.not_finite = static_cast<int>(c);
  }
  return all;
}

MovedBoundary move_curves(const BoundaryComplex& boundary, const BoundaryDisplacement& displacement, bool keep_area) {
  return move_curves(boundary, sample_displacements(boundary, displacement), keep_area);
}

MovedBoundary move_curves(const BoundaryComplex& boundary, const BoundaryDisplacements& displacements, bool keep_area) {
  MovedBoundary moved;
  if (displacements.not_finite > -2) {
    moved.status = MovedBoundary::Status::not_finite;
    moved.place = displacements.not_finite;
    return moved;
  }
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
    moved.vertices.push_back(boundary.vertices[v] + displacements.at_vertex[v]);
  for (std::size_t c = 0; c < boundary.curves.size(); ++c) {
    const Curve& curve = boundary.curves[c];
    moved.place = static_cast<int>(c);
    BSpline spline = curve.spline;
    BSpline vectors = spline;
    if (!vectors.interpolate(displacements.at_greville[c])) {
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
