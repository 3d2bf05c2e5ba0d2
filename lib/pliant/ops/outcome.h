// lib/pliant/ops/outcome.h: what an operation says when it refuses.
#pragma once
namespace pliant {

/// The closed list of reasons. After any of them but `done` the mesh is bit for bit as it was.
enum class Refusal {
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
/// The reason in a few words, for reports.
const char* describe(Refusal refusal);

/// How carried fields are fitted after a flip or a removal.
enum class Projection { l2, conservative, limited };

/// What is kept where an operation changes the region that elements cover: functions of degree <= 1 stay themselves, or
/// the integral of each component stays (of a field by face, over each face).
enum class RegionChange { reproduce, conserve };

struct RefitOptions {
  Projection projection = Projection::limited;
  /// A flip of elements whose control points are off their straight places by less than this part of their extent lays
  /// the new edge straight (0: only of straight ones): for meshes whose inner edges are to be straight in the end.
  double straight_below = 0;
  RegionChange region_change = RegionChange::reproduce;
};

}  // namespace pliant
