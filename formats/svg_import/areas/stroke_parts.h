// formats/svg_import/areas/stroke_parts.h: the steps of an outline as smooth parts that know their normals.
#pragma once
#include <array>
#include <vector>

#include "formats/svg_import/areas/outline.h"

namespace pliant::svg {

/// A line, cubic curve or arc without a stop inside.
class StrokePart {
 public:
  static StrokePart cubic(const std::array<Point, 4>& points);
  static StrokePart arc(const Point& center, const Vector& u, const Vector& v, double from, double sweep,
                        const Point& start, const Point& end);

  bool is_line() const { return kind_ == Kind::line; }
  double first() const { return first_; }
  double last() const { return last_; }
  Point at(double t) const;
  /// The direction, of unit length; at a stop the limit towards the inside.
  Vector tangent(double t) const;
  /// The length of the derivative, and the curvature, which is positive where the curve turns to the left.
  double speed(double t) const;
  double curvature(double t) const;
  double length(double from, double to) const;
  /// The part between two parameters.
  StrokePart between(double from, double to) const;
  /// Appends the parameters where the speed vanishes, or the curvature is 1 / r or -1 / r.
  void add_events(double r, std::vector<double>& out) const;

 private:
  enum class Kind { line, cubic, arc };
  Vector derivative(double t) const;
  Vector second(double t) const;

  Kind kind_ = Kind::line;
  bool is_bent_ = true;
  std::array<Point, 4> c_{};  // of an arc: centre, u, v
  double first_ = 0, last_ = 1;
  Point start_, end_;
};

/// A subpath: parts, each of which starts where the one before it ends.
struct StrokePath {
  std::vector<StrokePart> parts;
  Point start;  ///< also where there are no parts
  bool is_closed = false;
};

/// The subpaths of an outline. A single point that is drawn to ("M1 1h0", "M1 1z") is a path without parts.
std::vector<StrokePath> stroke_paths(const Outline& outline);

}  // namespace pliant::svg
