// lib/pliant/ops/outcome.h: how an operation ended: done, or the reason why it was refused.
#pragma once
namespace pliant {

/// How an operation ended. Every value but `done` is a refusal, after which the mesh is bit for bit as it was.
enum class Outcome {
  done,               ///< the operation was carried out
  outer_boundary,     ///< the edge has only one triangle
  constrained,        ///< the edge or vertex lies on a curve
  corner,             ///< the vertex ends a curve, or several curves meet there
  not_convex,         ///< the logical quadrilateral is not strictly convex
  edge_exists,        ///< an edge joins the two vertices already (or the point is a vertex already)
  bent_side,          ///< a bent inner edge is in the way
  would_bend,         ///< there is only room for a badly bent edge
  covers_corner,      ///< the new triangle would cover a smooth or reflex corner of the boundary
  would_invert,       ///< no valid place for the control points was found
  not_removable,      ///< no ear can be flipped, the curve has no span to spare, or there is no point to move
  exceeds_tolerance,  ///< knot removal would move the curve too far
  too_curved,         ///< the edge that knot removal leaves would turn too much
  loses_integral,     ///< values within their limits cannot keep the integral of a field
  not_in_domain       ///< the point is outside the element or edge
};
/// The outcome in a few words, for reports.
const char* describe(Outcome outcome);

}  // namespace pliant
