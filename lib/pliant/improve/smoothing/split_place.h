// lib/pliant/improve/smoothing/split_place.h: where is an edge on a curve split best, and which other one with it?
#pragma once
#include "pliant/improve/refining/sharp_corners.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// The parameter, in (0, 1) along the half-edge, of a point that is as far from a sharp corner as the vertex opposite
/// on the other side of its wedge, or on a shell around the end that is such a corner, else as far from one end as from
/// the other; nearer to one end where the logical triangles would be turned over otherwise: a curve bends past vertices
/// that stand close to it, and its chord does not.
double split_place(const Mesh& mesh, HalfEdgeId h, const SharpCorners& corners);

/// An edge on the other side of a narrow wedge that is to be split with this one, at the same distance from the corner.
struct SplitPartner {
  PointId first = none, last = none;  ///< its ends; none: there is none
  PointId corner = none;
  explicit operator bool() const { return corner != none; }
};
/// The partner of an edge whose chord, or its partner's, is further from its curve than the sides of the wedge are from
/// each other: if one alone were split the logical triangles between them would be turned over.   `s`: where the edge
/// is to be split
SplitPartner find_partner(const Mesh& mesh, HalfEdgeId h, const SharpCorners& corners, double s);
/// The parameter at which an edge is `radius` away from a point that it leads away from or towards.
double place_at_radius(const Mesh& mesh, HalfEdgeId h, const Point& from, double radius);

/// Logical triangles are turned over where a curve is far from its chord: the edge on a curve that bends most beside
/// those that hang together with t; none where t is not turned over, or nothing beside it bends.
HalfEdgeId curve_that_turns_over(const Mesh& mesh, TriangleId t);

}  // namespace pliant
