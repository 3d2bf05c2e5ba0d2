// formats/picture/isolines/arc.h: a part of an isoline in one piece of an element, drawn as Bézier curves.
#pragma once
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// A triangular piece of an element in which a polynomial grows everywhere along one direction, so that the isoline at
/// 0 consists of arcs that do not turn back. Coordinates are (xi2, xi3) in the piece.
struct MonotonePiece {
  int degree;                    ///< of the geometry
  std::vector<double> geometry;  ///< x, y of its control net
  int field_degree;
  std::vector<double> field;
  Vector rise;  ///< the direction in which the polynomial grows, of length 1
};

/// An end of an arc: where it is in the piece and in the plane.
struct ArcEnd {
  Point local, place;
};

/// Appends Bézier curves of degree 1 or 3 that follow the isoline from one end to the other (the polynomial is above
/// zero to the left) and meet its tangents at their ends. At seven places of each the curve was found to be within half
/// the tolerance of the isoline.
void draw_arc(const MonotonePiece& piece, const ArcEnd& from, const ArcEnd& to, double tolerance,
              std::vector<std::vector<Point>>& curves);

}  // namespace pliant
