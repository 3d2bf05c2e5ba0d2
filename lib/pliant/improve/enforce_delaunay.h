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
/// refused. Where a logical triangle has turned over (a vertex has crossed the chord of an edge that bends round it),
/// an edge is flipped if that makes both triangles positive. Other edges whose old or new logical triangles are not all
/// positive are left alone and counted.
///
/// The report lists the edges that still want their flip at the end, with the reason of the refusal and the middle of
/// the edge. Edges that were refused at first and flipped later, or have become Delaunay, are not listed.
///
/// Complexity  O(triangles + flips); a mesh with nothing to flip is only read
PassReport enforce_delaunay(Mesh& mesh, const DelaunayOptions& options = {});

}  // namespace pliant
