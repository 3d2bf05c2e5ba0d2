// formats/picture/svg/path.h: numbers and Bézier curves as SVG's path data, y upwards.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// Appends the numbers and path segments of one drawing to a text.
class SvgPath {
 public:
  /// Numbers are rounded to `resolution` times `size`, the size of the drawing (more exactly, to the next lower power
  /// of ten). Curves of degree above 3 are drawn within `tolerance`, a length.
  SvgPath(std::string& out, double size, double tolerance, double resolution = 1e-7);

  SvgPath& text(std::string_view words) { return out_ += words, *this; }
  SvgPath& number(double value);
  /// Appends the point's x and -y with a space between.
  SvgPath& point(const Point& p);
  SvgPath& move_to(const Point& p);
  /// Appends a Bézier curve from its first control point, where the path is now: as L where it is straight up to the
  /// rounding, as Q or C for degrees 2 and 3. From degree 4 on the curve is halved until the cubics with the ends and
  /// end derivatives of its parts are within the tolerance, which is bounded by differences of control points.
  SvgPath& curve_to(const std::vector<Point>& polygon);

 private:
  bool is_straight(const std::vector<Point>& polygon) const;
  void cubics(const std::vector<double>& polygon, int depth);

  std::string& out_;
  double tolerance_;
  int decimals_;  // digits behind the point; negative: the shortest form of each number
};

}  // namespace pliant
