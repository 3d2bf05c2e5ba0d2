// lib/pliant/improve/enforce_delaunay.h: flips until the logical mesh is Delaunay (paper §5.3.1).
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"
#include "pliant/ops/refit_options.h"

namespace pliant {

struct DelaunayOptions {
  long max_flips = -1;  ///< negative: no limit (it terminates)
  RefitOptions refit;
};

/// Flips unconstrained edges until every one is locally Delaunay in the logical mesh (exact in-circle), or its flip was
/// refused. A logical triangle that has turned over (a vertex has crossed an edge that bends round it) is flipped back
/// where that makes both triangles positive; other edges whose old or new logical triangles are not all positive are
/// left alone and counted.
///
/// The report lists the refusals that lasted: edges of the mesh it leaves that still want their flip, with the reason
/// and the middle of the edge. (Edges that were refused first and flipped later, or are Delaunay by now, are not in
/// it.)
///
/// Complexity  O(triangles + flips); a mesh with nothing to flip is only read
PassReport enforce_delaunay(Mesh& mesh, const DelaunayOptions& options = {});

}  // namespace pliant
