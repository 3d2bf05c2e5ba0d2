// lib/pliant/ops/level_jacobian.h: det J of an element made to vary less.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// Makes det J vary less in element t and in the up to three elements beyond its unconstrained edges: the bend of a
/// curve is shared with the elements beside. Two Gauss-Newton steps move the control points inside these edges and
/// elements so that the Bernstein coefficients of det J, each divided by the mean that its element had before, come
/// near to 1 in the least-squares sense. `part`, in (0, 1], is how much of each step is gone. Fields are refitted.
///
/// Refuses     no point that may move (constrained); an element that would not be valid (would_invert); a field's
///             integral that limited values cannot keep (loses_integral)
/// Complexity  O(p^6)
Outcome level_jacobian(Mesh& mesh, TriangleId t, double part = 1, const RefitOptions& options = {});

}  // namespace pliant
