// lib/pliant/boundary/gap_pieces.h: parts of Bézier curves, and what bounds the distance between two (private).
#pragma once
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "pliant/geometry/spline/bspline.h"

namespace pliant {

/// A part of a Bézier curve. One of degree 0 is a single place.
struct GapPiece {
  std::array<Point, max_curve_degree + 1> points;
  int degree = 0;
  double from = 0, to = 1;  ///< parameters on the whole curve

  std::span<const Point> polygon() const { return {points.data(), static_cast<std::size_t>(degree) + 1}; }
  Point& at(int i) { return points[static_cast<std::size_t>(i)]; }
  const Point& at(int i) const { return points[static_cast<std::size_t>(i)]; }
  double parameter(double u) const { return u == 1 ? to : from + u * (to - from); }
};

GapPiece whole_piece(std::span<const Point> polygon);
std::pair<GapPiece, GapPiece> halves(const GapPiece& piece);
/// The end at the start (or not) as a piece of degree 0.
GapPiece end_of(const GapPiece& piece, bool start);

/// The sum of the angles between the legs of a polygon (radians): the curve's tangents turn by no more in all.
double turning(std::span<const Point> polygon);
/// The angle between two vectors; 0 if one is 0.
double angle_between(const Vector& a, const Vector& b);
/// The first leg of a curve that is not 0, seen from one of its ends; 0 if all are.
Vector outward_leg(std::span<const Point> polygon, bool from_start);
double polygon_length(std::span<const Point> polygon);

/// How near two chords are, and where (parameters in [0, 1]).
struct ChordDistance {
  double distance, u, v;
};
ChordDistance chord_distance(const GapPiece& a, const GapPiece& b);
/// The greatest distance of a control point from the chord: no place of the curve is farther from it.
double height_over_chord(const GapPiece& piece);

/// 1 if the distance to every place of `other` grows along the piece everywhere, -1 if it falls everywhere, else 0.
int slope_of_distance(const GapPiece& piece, const GapPiece& other);

/// A place on a curve with two derivatives by the piece's own parameter in [0, 1].
struct CurvePlace {
  Point place;
  Vector first, second;
};
CurvePlace evaluate_piece(const GapPiece& piece, double u);

/// Parameters on two pieces where Newton's method for "the joining line is normal to both" ends, held in [0, 1].
std::pair<double, double> polish(const GapPiece& a, const GapPiece& b, double u, double v);

}  // namespace pliant
