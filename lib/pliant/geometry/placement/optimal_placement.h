// lib/pliant/geometry/placement/optimal_placement.h: the best place of one control point (paper §5.5).
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// One element around the control point that moves: its whole net, and which entry of it is the moving one.
struct PlacementElement {
  std::span<const Point> net;
  int moving;
};

enum class PlacementMeasure { element, control_mesh };  ///< true measures, or the paper's control triangles

struct Placement {
  enum class Outcome {
    placed,    ///< `place` makes every element certified valid
    hopeless,  ///< proved: no place makes all of them valid (none within 1000 half extents of the star)
    stuck      ///< neither could be shown within the cuts allowed
  };
  enum class Program {
    shape,  ///< `value` is the least tau
    area    ///< `value` is the least coefficient of det J, or control triangle, by scale
  };
  Outcome outcome;
  Point place;
  double value;
  Program program;
};

/// A place that makes all elements valid: maximises the least Bernstein coefficient of det J, each element's divided by
/// the square of its size (the diagonal of the box of its fixed control points), over the elements; every coefficient
/// is affine in the point, so this is a linear program in (x, y, least), with at most three active constraints. Where
/// its optimum is not certified, the pieces whose coefficients hold it down are bisected, until the optimum is
/// certified or proved hopeless. `value` is that of the last program, at most 1e-10 below its optimum: a lower bound of
/// det J by scale at the place, and without cuts the optimum over the coefficients of det J itself. Places are looked
/// for as far as four times the half extent of the fixed control points from their middle; ties: nearest to `start`.
/// Design: optimal placement of one control point; Amenta, Bern, Eppstein (1999).
///
/// control_mesh: the least area of a control triangle that the point is a corner of, by the square of half the extent
/// of the star; `stuck` where its best place leaves an element that is not certified.
///
/// `most_pieces` bounds the subdivision: a few are enough where the point is one of several that move in turn, and the
/// outcome `stuck` is no verdict.
Placement untangle_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                         PlacementMeasure measure = PlacementMeasure::element, int most_pieces = 400);

/// How near to its optimum improve_point comes by default, relative to the optimum: where it costs little, as near as
/// it can.
constexpr double placement_accuracy(int degree) { return degree <= 2 ? 1e-10 : 2e-3; }

/// Maximises min tau(xi) over the elements and their points xi: {tau(xi) >= t}, t > 0, is a disk of places for each xi,
/// and the worst xi are added as cuts. With t the best of the whole plane, min tau at the place is at least
/// t - max(accuracy * t, 1e-10). `value` is a lower bound of it; at p <= 2 the two differ by what rounding leaves
/// unknown (most often 1e-14, but 1e-8 where an element is flat to 1e-6), above by at most accuracy / 4 of it as far as
/// 400 bisections of an element lead. A point xi whose tau does not depend on the place may be the worst of all; then
/// every place is an optimum that keeps the others above it.
///
/// From a valid start the place is never worse than `start`, which stays bit for bit where it is within the accuracy.
/// The start need not be valid. Where no place has a positive tau, or none was found, the result is that of
/// untangle_point, and `program` says so. Every element is certified at a place that is `placed`.
///
/// control_mesh: the least tau of the control triangles that the point is a corner of, to 1e-10; where that place
/// leaves an element that is not certified, the farthest certified place on the straight way to it (within 1/256 of the
/// way) from the start, or, from a start that is not valid, from the best place of the area program on the true
/// elements.
Placement improve_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                        PlacementMeasure measure, double accuracy);
inline Placement improve_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                               PlacementMeasure measure = PlacementMeasure::element) {
  return improve_point(degree, elements, start, measure, placement_accuracy(degree));
}

}  // namespace pliant
