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

/// The same at the places that decide the motion.
struct BoundaryDisplacements {
  std::vector<Vector> at_vertex;
  std::vector<std::vector<Vector>> at_greville;  ///< for each curve, at its Greville abscissae
  int not_finite = -2;                           ///< the first curve with one that is not finite; -1: a vertex has one

  /// The ends of an open curve move with their vertices, since corners must stay shared.
  void join_ends(const Curve& curve, std::size_t number);
};
BoundaryDisplacements sample_displacements(const BoundaryComplex& boundary, const BoundaryDisplacement& displacement);

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
MovedBoundary move_curves(const BoundaryComplex& boundary, const BoundaryDisplacements& displacements, bool keep_area);

}  // namespace pliant
