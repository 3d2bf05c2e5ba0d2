// lib/pliant/ops/remove_point.h: a vertex of degree three, and splits undone (paper §5.2.2).
#pragma once
#include <cmath>
#include <utility>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// Removes an inner vertex of degree three that is on no curve: 3→1. Where the elements are a de Casteljau subdivision
/// the parent is restored, else projected.
Outcome remove_degree_three(Mesh& mesh, PointId v, const RefitOptions& options = {});

/// Removes any inner vertex that is on no curve: ears first (Devillers's order, each ear a flip), then 3→1; un-split
/// where it applies. Rolls back as a whole.
Outcome remove_inner_vertex(Mesh& mesh, PointId v, const RefitOptions& options = {});

struct CurveRemoval {
  Outcome outcome = Outcome::done;
  double error = 0;  ///< bound of the distance between old and new curve
  /// Largest change of a component's integral over the footprint, relative to that of the absolute control values; 0
  /// to rounding where the curve stays where it is, or options.region_change is `conserve`.
  double integral_change = 0;
};
/// Bounds of what removing a knot may do to its curve.
struct CurveTolerance {
  double total;                   ///< of the curve's accumulated error (length)
  double step = HUGE_VAL;         ///< of this removal's own error (length)
  bool keep_area = false;         ///< control points near the knot take up the change of the area that the curve sweeps
  double max_turning = HUGE_VAL;  ///< of the edge that is left (radians)
};
/// Which curves removals that were only foreseen have changed, and where vertices would be.
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
/// What the curve alone says about the removal of a vertex, after those that were foreseen before: a corner, its
/// minimum of spans, the error against its bounds, the turning of the edge that would be left. `done` where nothing of
/// that refuses; the knot is then gone from the curve, whose elements stay as they were. Requires    a transaction of
/// the caller, who rolls it back after the last removal that is foreseen
CurveRemoval foresee_curve_removal(Mesh& mesh, PointId v, const CurveTolerance& tolerance, ForeseenCurves& foreseen);

/// Removes a vertex in the interior of a curve: knot removal with its footprint, 4→2 or 2→1 after the ears. Refused
/// when an error would exceed its bound.
CurveRemoval remove_curve_vertex(Mesh& mesh, PointId v, const CurveTolerance& tolerance,
                                 const RefitOptions& options = {});

}  // namespace pliant
