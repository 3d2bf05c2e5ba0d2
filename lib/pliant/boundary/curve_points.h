// lib/pliant/boundary/curve_points.h: points and parts of one Bézier curve, the point nearest to another, monotone
// pieces.
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// The curve's point nearest to p.
struct Nearest {
  double t;
  double distance;
};
Nearest nearest_on_curve(std::span<const Point> polygon, const Point& p);

/// Value and derivative at t.
struct CurveJet {
  Point value;
  Vector derivative;
};
CurveJet bezier_jet(std::span<const Point> polygon, double t);

/// The value at t, and the control points of the part [t0, t1] (as many as `polygon`; t1 < t0: reversed).
Point bezier_point(std::span<const Point> polygon, double t);
void bezier_part(std::span<const Point> polygon, double t0, double t1, std::span<Point> out);

/// The parameters in (0, 1), ascending, that cut a Bézier curve into pieces monotone in x and in y, none of them with
/// an extent (of its control polygon) below `least`; coordinates smaller than `least` apart count as equal.
std::vector<double> monotone_cuts(std::span<const Point> polygon, double least);

}  // namespace pliant
