// formats/svg_import/affine.h: affine maps of the plane.
#pragma once
#include <cmath>

#include "pliant/geometry/point.h"

namespace pliant::svg {

/// (x, y) -> (a x + c y + e, b x + d y + f), SVG's letters.
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  Point operator()(const Point& p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  Vector turn(const Vector& v) const { return {a * v.x + c * v.y, b * v.x + d * v.y}; }
  /// The map that applies `m` first and then this one.
  Affine operator*(const Affine& m) const {
    return {a * m.a + c * m.b, b * m.a + d * m.b,     a * m.c + c * m.d,
            b * m.c + d * m.d, a * m.e + c * m.f + e, b * m.e + d * m.f + f};
  }
  /// Requires    a determinant other than 0
  Affine inverse() const {
    const double det = determinant();
    const Affine turn{d / det, -b / det, -c / det, a / det, 0, 0};
    const Point moved = turn({e, f});
    return {turn.a, turn.b, turn.c, turn.d, -moved.x, -moved.y};
  }
  double determinant() const { return a * d - b * c; }
};

}  // namespace pliant::svg
