// lib/pliant/ops/removal/merge.h: two triangles of a fan become one; three become one.
#pragma once
#include <span>
#include <vector>

#include "pliant/mesh/mesh.h"
#include "pliant/ops/build_triangle.h"
#include "pliant/ops/refit_options.h"
#include "pliant/ops/removal/recover_parent.h"

namespace pliant {

/// The link vertices of one side of v, in counter-clockwise order: triangles (v, link[i], link[i + 1]).
using Fan = std::vector<PointId>;

/// How deep v lies in the circle of an ear (power of the point, negative of its sign): small ears go first.
double depth_in_circle(const Point& a, const Point& b, const Point& c, const Point& v);

/// Flips spokes of the fan (Devillers's order: the ear whose circle v is barely inside first) until `triangles` are
/// left. False when no ear can be flipped: the caller rolls back.
bool reduce_fan(Mesh& mesh, PointId v, Fan& fan, bool closed, int triangles, const RefitOptions& options);

/// The parent of the two triangles (v, fan[0], fan[1]) and (v, fan[1], fan[2]) if they are a subdivision of one with an
/// edge from fan[0] to fan[2]. Corner order of the parent: fan[0], fan[1], fan[2].
/// `long_edge`: the control points of the parent's edge fan[2] to fan[0] where they are known already; else empty.
bool recover_merged(const Mesh& mesh, PointId v, std::span<const PointId> fan, ParentRecovery& parent,
                    std::span<const Point> long_edge = {});

/// Replaces the triangles of h (v to fan[0]) and of the next spoke h1 (v to fan[1]) by one, with `long_edge` from
/// fan[2] to fan[0]; frees the spoke between them. Returns the triangle. The caller frees v, links the long edge and
/// places the points. Of two fans, find both h before the first is merged: the star of v falls apart.
TriangleId merge_fan(Mesh& mesh, HalfEdgeId h, const EdgePoints& long_edge);

}  // namespace pliant
