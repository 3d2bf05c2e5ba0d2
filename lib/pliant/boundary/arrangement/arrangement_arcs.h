// lib/pliant/boundary/arrangement/arrangement_arcs.h: curves cut at all their intersections.
#pragma once
#include <span>
#include <vector>

#include "pliant/boundary/arrangement.h"

namespace pliant {

/// How a face's winding number on the left of a curve exceeds that on its right; ascending by face, none 0.
using Winding = std::vector<std::pair<int, int>>;

/// sum += times * by
void add_winding(Winding& sum, const Winding& by, int times = 1);

/// A curve of an arrangement, and how the winding numbers on its two sides differ.
struct SidedCurve {
  const BSpline* spline;
  Winding jump;
  int line = -1;  ///< which drawn line it belongs to; -1 for borders
};

/// A part of a curve, monotone in x and in y, that meets others at its ends only.
struct Arc {
  int curve;
  double t0, t1;  ///< parameters on the curve
  int from, to;   ///< nodes; the same where the arc is shorter than the snap
  std::size_t first_point;
  int degree;
};

/// All arcs, by curve and along it, scaled by a power of two to a size near 1.
struct ArcNetwork {
  int exponent = 0;          ///< a coordinate here, times 2^exponent, is one of the input
  std::vector<Point> nodes;  ///< first the input's own: its vertices, then ends and breaks of curves; then the cuts
  std::vector<Arc> arcs;
  std::vector<Point> points;  ///< control points; the ends equal the nodes bit for bit

  std::span<const Point> polygon(const Arc& arc) const {
    return {points.data() + arc.first_point, static_cast<std::size_t>(arc.degree) + 1};
  }
};

/// ArrangeOptions as lengths in the network's scale.
struct ArcTolerances {
  double touch, sliver, tip;
};

/// Cuts the curves at their intersections.
/// Requires    a size between 1e-100 and 1e100, or 0
ArcNetwork cut_curves(std::span<const SidedCurve> curves, std::span<const Point> vertices,
                      const ArrangeOptions& options, ArcTolerances& tolerances);

}  // namespace pliant
