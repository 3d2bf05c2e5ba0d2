// lib/pliant/ops/outcome.h: what came of an operation: done, or the reason why it refused.
#pragma once
namespace pliant {

/// What came of an operation. After any refusal, all but `done`, the mesh is bit for bit as it was.
enum class Outcome {
  done,               ///< the operation was carried out
  outer_boundary,     ///< the edge has one triangle
  constrained,        ///< the edge lies on a curve
  corner,             ///< the vertex ends a curve, or several curves meet there
  not_convex,         ///< the logical quadrilateral is not strictly convex
  edge_exists,        ///< the new edge would join two vertices that an edge joins already
  bent_side,          ///< a bent inner edge is in the way
  would_bend,         ///< there is room for a badly bent edge only
  covers_corner,      ///< the new triangle would cover a smooth or reflex corner of the boundary
  would_invert,       ///< no valid place for the new control points
  not_removable,      ///< the star cannot be reduced, or the curve is at its minimum
  exceeds_tolerance,  ///< knot removal would move the curve too far
  too_curved,         ///< the edge that knot removal leaves would turn too much
  loses_integral,     ///< a field's values within their limits cannot keep its integral
  not_in_domain       ///< the point is outside
};
/// The outcome in a few words, for reports.
const char* describe(Outcome outcome);

}  // namespace pliant
