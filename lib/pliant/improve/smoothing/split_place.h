// lib/pliant/improve/smoothing/split_place.h: where to split an edge on a curve, and which other edge to split with it.
#pragma once
#include "pliant/improve/refining/sharp_corners.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// The parameter, in (0, 1) along the half-edge, at which an edge on a curve is best split. The first of these that
/// applies:
/// - Opposite a vertex on the other side of a wedge (SharpCorners): as far from the corner as that vertex.
/// - At a sharp corner, which is one end of the edge: on a shell around that end.
/// - Elsewhere: as far from one end as from the other. If logical triangles would be turned over by that, nearer to one
///   end, if that helps: a curve bends past vertices that stand close to it, and its chords do not.
double split_place(const Mesh& mesh, HalfEdgeId h, const SharpCorners& corners);

/// An edge on the other side of a narrow wedge that is to be split together with another one, at the same distance from
/// the corner.
struct SplitPartner {
  PointId first = none, last = none;  ///< its ends; `none` where there is no such edge
  PointId corner = none;
  explicit operator bool() const { return corner != none; }
};
/// The partner of an edge that is to be split at the parameter s. An edge has a partner where the curve of either is so
/// far from its chord, compared with the distance between the two sides of the wedge, that a split of one alone might
/// turn over the logical triangles between them.
SplitPartner find_partner(const Mesh& mesh, HalfEdgeId h, const SharpCorners& corners, double s);
/// The parameter at which an edge is `radius` away from a point. Requires that the edge leads away from the point or
/// towards it.
double place_at_radius(const Mesh& mesh, HalfEdgeId h, const Point& from, double radius);

/// Logical triangles are turned over where a curve is far from its chord. Returns the most bent edge on a curve among
/// the edges of the triangles that are turned over and connected to t; none where t is not turned over, or no such edge
/// bends.
HalfEdgeId curve_that_turns_over(const Mesh& mesh, TriangleId t);

}  // namespace pliant
