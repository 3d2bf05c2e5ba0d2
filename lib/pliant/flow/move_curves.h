// lib/pliant/flow/move_curves.h: the boundary complex carried along as splines (paper §6; design: Motion).
#pragma once
#include <functional>
#include <vector>

#include "pliant/boundary/boundary_complex.h"

namespace pliant {

/// Where the motion takes the boundary: from a place on it (a curve and a parameter, or a vertex) to a displacement.
struct BoundaryDisplacement {
  std::function<Vector(int curve, double parameter)> on_curve;
  std::function<Vector(int vertex)> at_vertex;
};

struct MovedBoundary {
  enum class Status { done, not_finite, not_interpolable };
  Status status = Status::done;
  int place = -1;  ///< of a failure: the curve, or -1 for a vertex
  std::vector<Point> vertices;
  std::vector<BSpline> splines;  ///< in the order of the curves
  double area_offset = 0;        ///< the largest normal offset that keep_area took (length)
};

/// The curves through the moved points at the Greville abscissae, knots unchanged: continuity at every knot survives,
/// shared vertices stay shared bit for bit, and the displacement is what is interpolated, so where nothing moves not a
/// bit changes. With keep_area each closed curve is offset along its normals by one length, so that it encloses the
/// area that it had (to rounding).   Complexity O(control points * degree^2)
MovedBoundary move_curves(const BoundaryComplex& boundary, const BoundaryDisplacement& displacement, bool keep_area);

}  // namespace pliant
