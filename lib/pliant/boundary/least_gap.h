// lib/pliant/boundary/least_gap.h: where do curves come closest to each other, or back to themselves?
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// An edge on a curve, as a Bézier curve. Two edges end in the same vertex exactly if they name the same one.
struct GapEdge {
  std::span<const Point> polygon;
  int curve;     ///< the number of its curve
  int from, to;  ///< the vertices at its ends
};

/// Two places of the boundary that face each other across a gap.
struct Gap {
  double distance;    ///< between the two places
  int first, second;  ///< the numbers of the edges
  double s, t;        ///< the parameters in [0, 1] on them
  Point place, other;
};

/// The thinnest gap that is thinner than `below`.
///
/// Two places are across a *gap* from each other if the line between them is normal to the boundary at both (at a
/// corner: no way along the boundary leads closer), and if, of these, one holds:
/// - They are on curves that have no end in common.
/// - The way between them, along their one curve or along two by a common end, is more than 4 times the distance: the
///   middle of a thin body, or a neck.
/// - That way is more than twice the distance, and the distance is least there, compared with places beside them.
/// On a circle that way is at most pi/2 times the distance.
/// So neighbours on a curve are no gap, and neither is the wedge between two curves that leave a common vertex (corner,
/// cusp), whatever its angle, as long as it only widens. Where two edges cross or touch elsewhere than at a common
/// vertex, the gap is 0.
///
/// Shapes      the edges of a curve stand together, in its direction, each from where the one before ends; a curve is
///             closed if its last edge ends where its first one begins. Any degrees up to max_curve_degree.
/// Units       the distance is that of two places on the curves, so it is never too small but for rounding; the least
///             one is at most 1e-5 of itself smaller. Wedges are looked at down to below/64 from their vertex.
/// Complexity  O(n log n) where no edges are within `below` of each other but those near to each other along a curve
std::optional<Gap> find_least_gap(std::span<const GapEdge> edges, double below);

}  // namespace pliant
