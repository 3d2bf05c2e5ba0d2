// lib/pliant/ops/removal/removal_stretch.h: a curve that lost a knot, moved so that it sweeps the same area as before.
#pragma once
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The stretch of a curve around one of its breaks, as it is before the break is removed. The cost does not grow with
/// the length of the curve.
class RemovalStretch {
 public:
  RemovalStretch(const Mesh& mesh, CurveId curve, double knot);
  /// Moves the control points around the removed break so that the curve sweeps the same area as before. Returns a
  /// bound of the distance between the curve before the removal and the curve now. If the area cannot be restored by
  /// small steps, the result is infinite and the curve is useless: roll back.
  ///
  /// Requires    the break was removed from the mesh's curve after construction, in a transaction that is still open
  double restore_area(Mesh& mesh) const;

 private:
  /// The area that the curve sweeps on the spans of starts_.
  double area(const BSpline& spline) const;
  /// The control points that may move to restore the area.
  std::vector<int> points_around(const BSpline& spline, double place) const;
  /// A bound of the distance between the curve as it was and as it is now.
  double distance_to(Mesh& mesh, double place) const;

  CurveId curve_;
  double knot_;
  int multiplicity_;
  Point origin_;                ///< areas are swept as seen from here, the point of the curve at the break
  std::vector<double> starts_;  ///< where the spans start on which a removal changes the curve, without the break
  double area_ = 0;             ///< the area swept on these spans before the removal
  std::vector<Point> points_;   ///< the control points around the break before the removal
};

}  // namespace pliant
