// lib/pliant/ops/removal/merge.h: ears of a fan flipped away, and the two triangles that are left made one.
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/build_triangle.h"
#include "pliant/ops/refit_options.h"
#include "pliant/ops/removal/recover_parent.h"

namespace pliant {

/// The link vertices of v on one side, or all of them, counter-clockwise: its triangles are (v, fan[i], fan[i + 1]).
using Fan = std::vector<PointId>;

/// How deep v lies in the circle through a, b, c: minus the power of v with respect to it (length^2).
double depth_in_circle(const Point& a, const Point& b, const Point& c, const Point& v);

/// Flips away *spokes*, the edges from v to its link, until `triangles` are left in the fan; the flipped edges cut ears
/// off. Ears go in Devillers's order: the one in whose circle v lies least deep is first. If the fan is `closed` it
/// goes all the way round v. False if no ear can be flipped: the caller rolls back.
bool reduce_fan(Mesh& mesh, PointId v, Fan& fan, bool closed, int triangles, const RefitOptions& options);

/// Finds the parent of the two triangles (v, fan[0], fan[1]) and (v, fan[1], fan[2]), if they subdivide one that has an
/// edge from fan[0] to fan[2]. Corners of the parent: fan[0], fan[1], fan[2].
///
/// Shapes      long_edge: the control points of the parent's edge from fan[2] to fan[0], or empty if they are not known
bool recover_merged(const Mesh& mesh, PointId v, std::span<const PointId> fan, ParentRecovery& parent,
                    std::span<const Point> long_edge = {});

/// Replaces the triangles of h (v to fan[0]) and of the next spoke (v to fan[1]) by one triangle that has `long_edge`
/// from fan[2] to fan[0], and frees the spoke between them. Returns the triangle. The caller frees v, links the long
/// edge and places the points. A caller with two fans must find both h before the first merge, which breaks the star of
/// v up.
TriangleId merge_fan(Mesh& mesh, HalfEdgeId h, const EdgePoints& long_edge);

}  // namespace pliant
