// lib/pliant/ops/removal/removal_stretch.h: a curve that lost a knot, made to sweep the area that it did.
#pragma once
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// A curve around one of its breaks, as it is before the break goes. What it costs does not grow with the curve.
class RemovalStretch {
 public:
  RemovalStretch(const Mesh& mesh, CurveId curve, double knot);
  /// After the break was removed from the mesh's curve, in the same transaction: moves the control points around it so
  /// that the curve sweeps the area that it did. Returns a bound of the distance between the two curves then; infinite,
  /// the curve of no use, where too much is missing for small steps.
  double restore_area(Mesh& mesh) const;

 private:
  double area(const BSpline& spline) const;
  std::vector<int> points_around(const BSpline& spline, double place) const;
  /// A bound of the distance between the curve as it was and what it is now.
  double distance_to(Mesh& mesh, double place) const;

  CurveId curve_;
  double knot_;
  int multiplicity_;
  Point origin_;                ///< areas are seen from here: on the curve, nearby
  std::vector<double> starts_;  ///< of the spans on which a removal changes the curve, without the break
  double area_ = 0;             ///< swept on them
  std::vector<Point> points_;   ///< the control points around the break
};

}  // namespace pliant
