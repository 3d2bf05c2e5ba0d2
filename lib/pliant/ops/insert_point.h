// lib/pliant/ops/insert_point.h: new vertices: one triangle becomes three, an edge becomes two (paper §5.2.1).
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"

namespace pliant {

struct InsertResult {
  Outcome outcome = Outcome::done;
  PointId vertex = none;  ///< the new vertex; none if refused
};

/// Subdivides the triangle at xi (de Casteljau); geometry and fields stay. If the least coordinate of xi is below
/// `edge_tolerance`, the edge opposite to its corner is split instead (see split_edge). The triangles around the new
/// vertex use the slot of `t` and new slots.
///
/// Refuses     xi outside of t (not_in_domain); xi at a vertex (edge_exists); pieces that are not valid (would_invert)
InsertResult insert_point(Mesh& mesh, TriangleId t, const Barycentric& xi, double edge_tolerance = 1e-6);

/// Which pieces must be valid for a split: all of them, or only those of elements that are valid themselves.
enum class SplitCheck { all_valid, stays_valid };

/// Splits an edge, and the triangles on its sides (2→4 or 1→2), at parameter s in (0, 1) along the half-edge; geometry
/// and fields stay. If the edge lies on a curve, a knot is inserted there.
///
/// Refuses     s outside (0, 1) (not_in_domain); pieces that are not valid, or a span too short for a knot in between
///             (would_invert)
InsertResult split_edge(Mesh& mesh, HalfEdgeId h, double s, SplitCheck check = SplitCheck::all_valid);

}  // namespace pliant
