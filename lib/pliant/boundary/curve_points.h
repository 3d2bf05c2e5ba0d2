// lib/pliant/boundary/curve_points.h: points, parts, nearest points and monotone pieces of one Bézier curve.
#pragma once
#include <span>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// The point of a curve that is nearest to p: its parameter, and its distance from p.
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

/// The value at t, and the control points of the part between t0 and t1, as many as `polygon` has. If t1 < t0 the part
/// is reversed.
Point bezier_point(std::span<const Point> polygon, double t);
void bezier_part(std::span<const Point> polygon, double t0, double t1, std::span<Point> out);

/// The ascending parameters in (0, 1) that cut a Bézier curve into pieces monotone in x and in y. No piece gets a
/// control polygon smaller than `least`, and a leg that advances in x, or in y, by at most 1/16 of that counts as
/// constant there.
std::vector<double> monotone_cuts(std::span<const Point> polygon, double least);

}  // namespace pliant
