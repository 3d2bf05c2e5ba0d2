// lib/pliant/ops/remove_point.h: removes vertices, inside the domain or on a curve (paper §5.2.2).
#pragma once
#include <cmath>
#include <utility>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// Removes an inner vertex of degree three that is on no curve: 3→1. If the three elements are a de Casteljau
/// subdivision, their parent comes back; otherwise geometry and fields are fitted.
Outcome remove_degree_three(Mesh& mesh, PointId v, const RefitOptions& options = {});

/// Removes any inner vertex that is on no curve. If the vertex has four triangles that are the pieces of a split edge,
/// the split is undone (4→2). Otherwise ears are flipped away in Devillers's order until three triangles are left, and
/// these become one.
Outcome remove_inner_vertex(Mesh& mesh, PointId v, const RefitOptions& options = {});

/// What became of the removal of a vertex from a curve.
struct CurveRemoval {
  Outcome outcome = Outcome::done;
  double error = 0;  ///< a bound of the distance between the old and the new curve
  /// The largest change of a component's integral over the elements that changed, relative to the integral of the
  /// absolute control values. 0 where the curve stays where it is, or options.region_change is `conserve`.
  double integral_change = 0;
};
/// Bounds of what removing a knot may do to its curve.
struct CurveTolerance {
  double total;                   ///< greatest accumulated error of the curve (length)
  double step = HUGE_VAL;         ///< greatest error of this removal alone (length)
  bool keep_area = false;         ///< the curve must sweep the same area: control points near the knot move for it
  double max_turning = HUGE_VAL;  ///< greatest angle by which the edge that is left may turn (radians)
  double accuracy = HUGE_VAL;     ///< greatest resolution error of the edge that is left (length)
};
/// The removals that were only foreseen so far: which curves they changed, and where vertices would be.
struct ForeseenCurves {
  struct Changed {
    CurveId curve;
    int removals;
  };
  std::vector<Changed> curves;
  std::vector<std::pair<PointId, Point>> moved;  ///< vertices, and where they would be

  void clear() {
    curves.clear();
    moved.clear();
  }
  Changed* find(CurveId c) {
    for (Changed& each : curves)
      if (each.curve == c) return &each;
    return nullptr;
  }
};
/// Foresees whether the curve alone would refuse the removal of a vertex, after the removals foreseen before. It may
/// refuse since the vertex is a corner, the curve has no span to spare, an error would exceed its bound, the edge that
/// is left would turn too much, or another edge joins its ends already. If the result is `done`, the knot is gone from
/// the curve, but the elements stay as they are.
///
/// Requires    an open transaction, which the caller rolls back after the last removal that is foreseen
CurveRemoval foresee_curve_removal(Mesh& mesh, PointId v, const CurveTolerance& tolerance, ForeseenCurves& foreseen);

/// Removes a vertex inside a curve. Ears are flipped away until each side of the curve has two triangles at the vertex;
/// these become one on each side. The knot is removed from the curve, and the elements along the curve follow the
/// change.
///
/// Refuses     where the curve does (see foresee_curve_removal); where no ear can be flipped, a vertex that would move
///             belongs to something else too, elements would not be valid, or a field would lose a part of its integral
CurveRemoval remove_curve_vertex(Mesh& mesh, PointId v, const CurveTolerance& tolerance,
                                 const RefitOptions& options = {});

}  // namespace pliant
