// lib/pliant/ops/level_jacobian.h: det J of an element made to vary less.
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// Moves the control points inside the unconstrained edges of element t, and those inside t and the up to three
/// elements beyond these edges, so that the Bernstein coefficients of det J, each divided by its element's mean before,
/// are as near to 1 as can be in the least-squares sense: the bend of a curve is shared with the elements beside.
/// `part`, in (0, 1], is how much of the way they go. Fields are refitted.
///
/// Errors      refuses (mesh unchanged) where nothing is free, or an element would not be valid
/// Complexity  O(p^6), a Gauss-Newton step with the coefficients' exact derivatives, twice
Outcome level_jacobian(Mesh& mesh, TriangleId t, double part = 1, const RefitOptions& options = {});

}  // namespace pliant
