// lib/pliant/ops/removal/knot_removal.h: removes a knot from a curve of the mesh; the elements are not looked at yet.
#pragma once
#include <optional>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/removal/curve_passage.h"
#include "pliant/ops/remove_point.h"

namespace pliant {

/// What a removal would do to the curve, or why it is refused.
struct KnotRemoval {
  Outcome outcome = Outcome::done;
  double error = 0;  ///< a bound of how far the curve moves
  Passage passage;
  PointId from = 0, to = 0;  ///< the ends of the edge that is left
  double start = 0;          ///< the parameter of the curve at which that edge starts
};

/// Removes a break from a curve of the mesh; the points of the mesh stay. Returns a bound of how far the curve moves,
/// or nothing where BSpline::remove_break refuses. If tolerance.keep_area, the area is restored, unless the curve has
/// moved too far already.
///
/// Requires    an open transaction, which the caller rolls back if it refuses the removal
std::optional<double> remove_break(Mesh& mesh, CurveId c, double knot, const CurveTolerance& tolerance);

/// Removes the knot at vertex v from its curve, as remove_break does, and checks all that the curve decides alone.
/// `is_changed` tells that the curve has lost knots before while the elements stayed as they were.
///
/// Requires    an open transaction, which the caller rolls back if the removal is refused
KnotRemoval try_removal(Mesh& mesh, PointId v, const Star& star, const CurveTolerance& tolerance,
                        bool is_changed = false);

}  // namespace pliant
