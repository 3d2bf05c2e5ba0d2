// lib/pliant/ops/flip_edge.h: the other diagonal of two triangles (paper §5.2.3).
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// Flips the edge of half-edge h: topology, then geometry by the displacement projection (or optimal placement), then
/// fields. The new logical triangles must be positive, and at least one of the old ones. On success h is a half-edge of
/// the new edge. Refuses as `Outcome` says.
Outcome flip_edge(Mesh& mesh, HalfEdgeId h, const RefitOptions& options = {});

}  // namespace pliant
