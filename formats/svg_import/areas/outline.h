// formats/svg_import/areas/outline.h: the outline of a filled shape, as its commands, arcs by their centres.
#pragma once
#include <vector>

#include "formats/svg_import/affine.h"
#include "pliant/geometry/point.h"

namespace pliant::svg {

enum class Step : unsigned char {
  move,       ///< 1 point
  line,       ///< 1 point: the end; every step starts where the one before it ends
  quadratic,  ///< 2 points: control point, end
  cubic,      ///< 3 points: two control points, end
  arc,        ///< 5 points: centre, vectors u and v, (angle at the start, sweep), end; centre + u cos + v sin
  close       ///< no point
};

/// Number of points that a step has in `Outline::points`.
constexpr int point_count(Step step) {
  switch (step) {
    case Step::move:
    case Step::line:
      return 1;
    case Step::quadratic:
      return 2;
    case Step::cubic:
      return 3;
    case Step::arc:
      return 5;
    case Step::close:
      return 0;
  }
  return 0;
}

struct Outline {
  std::vector<Step> steps;
  std::vector<Point> points;

  void move(const Point& p) { add(Step::move, {p}); }
  void line(const Point& p) { add(Step::line, {p}); }
  void quadratic(const Point& q, const Point& p) { add(Step::quadratic, {q, p}); }
  void cubic(const Point& q, const Point& r, const Point& p) { add(Step::cubic, {q, r, p}); }
  void arc(const Point& center, const Vector& u, const Vector& v, double from, double sweep, const Point& end) {
    add(Step::arc, {center, u, v, {from, sweep}, end});
  }
  void close() { add(Step::close, {}); }
  bool empty() const { return steps.empty(); }
  /// Applies the map to all points.
  void transform(const Affine& map);

 private:
  void add(Step step, std::initializer_list<Point> added) {
    steps.push_back(step);
    points.insert(points.end(), added);
  }
};

/// The box of a mapped outline's control points, and of points on its arcs.
Box box_of(const Outline& outline, const Affine& map = {});

/// The least box of a mapped outline.
Box tight_box_of(const Outline& outline, const Affine& map = {});

/// Extends a box by another one, which may be empty.
inline void extend(Box& box, const Box& by) {
  if (!(by.low.x <= by.high.x)) return;
  box.extend(by.low);
  box.extend(by.high);
}

/// SVG's arc from one point to another (appendix B.2 of SVG 2): radii of 0 make a line, radii too small grow.
/// `turned` is the angle of the first axis, in degrees.
void add_arc(Outline& out, const Point& from, double rx, double ry, double turned, bool large, bool sweep,
             const Point& to);

}  // namespace pliant::svg
