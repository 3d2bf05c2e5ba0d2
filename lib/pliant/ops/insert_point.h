// lib/pliant/ops/insert_point.h: one triangle to three (paper §5.2.1).
#pragma once
#include "pliant/mesh/mesh.h"
#include "pliant/ops/outcome.h"

namespace pliant {

struct InsertResult {
  Outcome outcome = Outcome::done;
  PointId vertex = none;
};

/// Subdivides the triangle at xi (de Casteljau): geometry and fields unchanged. Where a coordinate of xi is below
/// `edge_tolerance` that edge is split instead (2→4 or 1→2; on a curve: knot insertion).
/// The new vertex's triangles are the slot of `t` and new ones. Refused as not_in_domain where xi is no point of t, as
/// edge_exists where it is a vertex.
InsertResult insert_point(Mesh& mesh, TriangleId t, const Barycentric& xi, double edge_tolerance = 1e-6);

/// What a split asks of the pieces: to be valid, or only those of valid elements to be so.
enum class SplitCheck { all_valid, stays_valid };

/// Splits an edge at s in (0, 1) along the half-edge; on a curve at the knot that this is, which is inserted.
/// Geometry and fields unchanged.
InsertResult split_edge(Mesh& mesh, HalfEdgeId h, double s, SplitCheck check = SplitCheck::all_valid);

}  // namespace pliant
