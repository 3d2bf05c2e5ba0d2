// lib/pliant/boundary/arrangement/arrangement_curves.h: kept arcs become B-splines again.
#pragma once
#include "pliant/boundary/arrangement/arrangement_graph.h"

namespace pliant {

/// A stretch of arcs of one curve that stays one B-spline.
struct KeptCurve {
  int curve;  ///< the index of the input's curve
  BSpline spline;
  int start, end;   ///< nodes; no_vertex for the whole of a closed curve
  int left, right;  ///< faces
};

/// The arcs that separate different faces or are drawn lines, chained through nodes where no other curve ends; ordered
/// by curve and along each curve.
std::vector<KeptCurve> chain_arcs(const ArcNetwork& network, std::span<const SidedCurve> curves,
                                  const ArrangementGraph& graph, const ArcTolerances& tolerances);

/// The part of a curve between two parameters, t0 < t1, clamped, with the knots between them; t1 may lie up to a period
/// beyond the end of a closed curve.   Complexity O(knots between t0 and t1, times degree)
BSpline part_of_curve(const BSpline& spline, double t0, double t1);

}  // namespace pliant
