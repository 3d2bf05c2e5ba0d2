// lib/pliant/ops/removal/knot_removal.h: the removal of a knot from a curve of the mesh, as far as the curve alone
// decides it.
#pragma once
#include <optional>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/removal/curve_passage.h"
#include "pliant/ops/remove_point.h"

namespace pliant {

/// What a removal would do to the curve, or why it is refused.
struct KnotRemoval {
  Outcome outcome = Outcome::done;
  double error = 0;
  Passage passage;
  PointId from = 0, to = 0;  ///< the ends of the edge that is left
  double start = 0;          ///< where it starts
};

/// Removes a break from a curve of the mesh, without moving the mesh's points; how far the curve moves at most. Keeps
/// the area if so wanted, unless the curve moves too far even without. In a transaction of the caller.
std::optional<double> remove_break(Mesh& mesh, CurveId c, double knot, const CurveTolerance& tolerance);

/// Removes the knot from the curve of the mesh, in a transaction of the caller, who rolls it back where the removal is
/// refused.   `is_changed`: the curve has lost knots before in this way, which the mesh has not followed
KnotRemoval try_removal(Mesh& mesh, PointId v, const Star& star, const CurveTolerance& tolerance,
                        bool is_changed = false);

}  // namespace pliant
