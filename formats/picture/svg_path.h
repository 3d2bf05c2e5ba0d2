// formats/picture/svg_path.h: numbers and Bézier curves as SVG's path data, y upwards.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant {

/// Appends numbers and path segments of one drawing.
class SvgPath {
 public:
  /// `size` is the drawing's; numbers are rounded to `resolution` of it (to the next lower power of ten), and curves of
  /// degree above 3 are drawn within `tolerance`, a length.
  SvgPath(std::string& out, double size, double tolerance, double resolution = 1e-7);

  SvgPath& text(std::string_view words) { return out_ += words, *this; }
  SvgPath& number(double value);
  /// The point's x and -y, with a space between.
  SvgPath& point(const Point& p);
  SvgPath& move_to(const Point& p);
  /// A Bézier curve from its first control point, where the path stands: L for those as good as straight, Q or C for
  /// degrees 2 and 3. From degree 4 on it is halved until the cubics with its ends and end tangents are within the
  /// tolerance: a bound, from the difference of the control points in the curve's own degree.
  SvgPath& curve_to(const std::vector<Point>& polygon);

 private:
  bool is_straight(const std::vector<Point>& polygon) const;
  void cubics(const std::vector<double>& polygon, int depth);

  std::string& out_;
  double tolerance_;
  int decimals_;  // negative: shortest form
};

/// The text with &, <, > and " escaped; what XML cannot hold (control characters) becomes U+FFFD.
std::string escape_xml(std::string_view text);
/// Six significant digits.
std::string short_number(double value);

}  // namespace pliant
