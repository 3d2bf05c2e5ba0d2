// lib/pliant/geometry/placement/optimal_placement.h: the best place of one control point (paper §5.5).
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// One element around the control point that moves: its whole net, and the index of the moving one in it.
struct PlacementElement {
  std::span<const Point> net;
  int moving;
};

enum class PlacementMeasure {
  element,      ///< det J and tau of the true elements
  control_mesh  ///< area and tau of the control triangles, as in the paper
};

struct Placement {
  enum class Outcome {
    placed,    ///< `place` makes every element certified valid
    hopeless,  ///< proved: no place within 1000 half extents of the star makes all of them valid
    stuck      ///< neither could be shown within the cuts allowed
  };
  enum class Program {
    shape,  ///< `value` is the least tau
    area    ///< `value` is the least coefficient of det J, or area of a control triangle, divided by a scale
  };
  Outcome outcome;
  Point place;
  double value;
  Program program;
};

/// A place that makes all elements valid. It maximises the least Bernstein coefficient of det J over the elements, the
/// coefficients of each divided by the square of its size (the diagonal of the box of its fixed control points). Every
/// coefficient is affine in the point, so this is a linear program in (x, y, least), with at most three active
/// constraints. If its optimum is not certified, the pieces whose coefficients hold it down are bisected, until it is
/// certified or proved hopeless. Places are sought up to four times the half extent of the fixed control points from
/// their middle; among equal ones the nearest to `start` is taken.
///
/// `value` is that of the last linear program, at most 1e-10 below its optimum. It is a lower bound of the least det J
/// divided by the square of the size, at the place.
///
/// With `control_mesh`, what is maximised is the least area of a control triangle that the point is a corner of,
/// divided by the square of half the extent of the star. If that place leaves an element that is not certified, it is
/// `stuck`.
///
/// `most_pieces` bounds the subdivision. A few pieces are enough where the point is one of several that move in turn,
/// so that the outcome `stuck` is no verdict.
///
/// Reference   Amenta, Bern, Eppstein, Optimal point placement for mesh smoothing (1999)
Placement untangle_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                         PlacementMeasure measure = PlacementMeasure::element, int most_pieces = 400);

/// How near improve_point comes to its optimum by default, relative to the optimum. At degrees up to 2, where this
/// costs little, it comes as near as it can.
constexpr double placement_accuracy(int degree) { return degree <= 2 ? 1e-10 : 2e-3; }

/// Maximises the least tau(xi) over the elements and their points xi. For each xi and each t > 0, the places with
/// tau(xi) >= t are a disk; the worst xi are added as cuts. If t is the best value in the whole plane, the least tau at
/// the place is at least t - max(accuracy * t, 1e-10). If the worst of all is a point xi whose tau does not depend on
/// the place, every place that keeps the others above it is an optimum.
///
/// `value` is a lower bound of the least tau. At degrees up to 2 the two differ by what rounding leaves unknown (most
/// often 1e-14, but 1e-8 where an element is flat to 1e-6); at higher degrees by at most accuracy / 4 of it, unless 400
/// bisections of an element do not reach that.
///
/// From a valid start the place is never worse than the start, which stays bit for bit if it is within the accuracy.
/// The start need not be valid. If no place has a positive tau, or none was found, the result is that of
/// untangle_point, and `program` says so. Every element is certified at a place that is `placed`.
///
/// With `control_mesh`, what is maximised, to 1e-10, is the least tau of the control triangles that the point is a
/// corner of. If that place leaves an element that is not certified, the result is the best certified place on the
/// straight way to it (found to 1/256 of the way). The way begins at the start, or, if the start is not valid, at the
/// place that untangle_point finds for the true elements.
Placement improve_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                        PlacementMeasure measure, double accuracy);
inline Placement improve_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                               PlacementMeasure measure = PlacementMeasure::element) {
  return improve_point(degree, elements, start, measure, placement_accuracy(degree));
}

}  // namespace pliant
