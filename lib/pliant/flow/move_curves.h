// lib/pliant/flow/move_curves.h: moves the boundary complex: vertices and splines (paper §6).
#pragma once
#include <functional>
#include <vector>

#include "pliant/boundary/boundary_complex.h"

namespace pliant {

/// The displacement of each place on the boundary, which is a curve and a parameter, or a vertex.
struct BoundaryDisplacement {
  std::function<Vector(int curve, double parameter)> on_curve;
  std::function<Vector(int vertex)> at_vertex;
};

struct MovedBoundary {
  enum class Status { done, not_finite, not_interpolable };
  Status status = Status::done;
  int place = -1;  ///< where it failed: the number of the curve, or -1 for a vertex
  std::vector<Point> vertices;
  std::vector<BSpline> splines;  ///< in the order of the curves
  double area_offset = 0;        ///< the largest offset that keep_area needed (length)
};

/// The boundary moved. Each curve keeps its knots, and so its continuity at every knot. To its control points are added
/// those of the spline that interpolates the displacement at the Greville abscissae, so that where nothing moves not a
/// bit changes. Shared vertices stay shared bit for bit. If `keep_area`, each closed curve is offset along its normals
/// by one length, so that it encloses the same area as before (to rounding).
///
/// Refuses     displacements that are not finite; curves whose displacement no spline on their knots interpolates
/// Complexity  O(control points * degree^2)
MovedBoundary move_curves(const BoundaryComplex& boundary, const BoundaryDisplacement& displacement, bool keep_area);

}  // namespace pliant
