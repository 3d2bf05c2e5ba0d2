#pragma once  // lib/pliant/geometry/optimal_placement.h: the best place of one control point (paper §5.5)
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
    hopeless,  ///< proved: no place makes all of them valid
    stuck      ///< neither could be shown within the cuts allowed
  };
  Outcome outcome;
  Point place;
  double value;  ///< untangle: least coefficient of det J over element scale; improve: min tau over the elements
};

/// A place that makes all elements valid: maximises the least Bernstein coefficient of det J, each element's divided by
/// its scale, over the elements; every coefficient is affine in the point, so this is a linear program in (x, y,
/// least), with at most three active constraints. Coefficients of subdivided pieces are added as cuts until the point
/// is certified or proved hopeless. Design: optimal placement of one control point; Amenta, Bern, Eppstein (1999).
///
/// `most_pieces` bounds the subdivision: a few are enough where the point is one of several that move in turn, and the
/// outcome `stuck` is no verdict.
Placement untangle_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                         PlacementMeasure measure = PlacementMeasure::element, int most_pieces = 400);

/// From a valid place, maximises min tau(xi) over the elements: {tau(xi) >= t} is a disk of positions for each xi, and
/// xi are added as cuts. Never returns a place that is worse than `start`, and every element is certified at the place.
/// Ties: nearest to `start`.
Placement improve_point(int degree, std::span<const PlacementElement> elements, const Point& start,
                        PlacementMeasure measure = PlacementMeasure::element);

}  // namespace pliant
