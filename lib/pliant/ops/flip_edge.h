// lib/pliant/ops/flip_edge.h: replaces an edge by the other diagonal of its two triangles (paper §5.2.3).
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

/// Flips the edge of half-edge h: first the topology, then the geometry by projecting displacements (or by optimal
/// placement), then the fields.
///
/// Ensures     on success h is a half-edge of the new edge
/// Refuses     an edge on a curve; new logical triangles that are not both positive, or old ones of which neither is; a
///             quadrilateral whose curved sides do not turn left where the new edge ends; two vertices that an edge
///             joins already; control points without a valid place; an integral that limited values cannot keep
Outcome flip_edge(Mesh& mesh, HalfEdgeId h, const RefitOptions& options = {});

}  // namespace pliant
