// formats/svg_import/areas/bezier_fit.h: the steps of an outline as Bézier pieces of a degree, within a tolerance.
#pragma once
#include <array>
#include <vector>

#include "pliant/geometry/point.h"

namespace pliant::svg {

inline constexpr int max_fit_degree = 3;

/// A Bézier curve of degree 1 to 3.
struct Piece {
  int degree = 1;
  bool fitted = false;  ///< is it only near to what the drawing says?
  std::array<Point, 4> points{};

  const Point& start() const { return points[0]; }
  Point& end() { return points[static_cast<std::size_t>(degree)]; }
  const Point& end() const { return points[static_cast<std::size_t>(degree)]; }
};

/// Turns the steps of an outline into pieces. Each piece starts bit for bit where the one before it ends.
class BezierFit {
 public:
  /// `follows_back` keeps the parts of straight curves that run back on themselves, as a stroke follows them.
  /// Requires    degree 2 or 3, tolerance > 0 (length)
  BezierFit(int degree, double tolerance, bool follows_back = false)
      : degree_(degree), tolerance_(tolerance), follows_back_(follows_back) {}

  /// Adds a quadratic curve. One whose control points are on a line becomes the line between its ends, since a part
  /// that runs back on itself has no interior; with `follows_back` it becomes the lines that it follows.
  void add_quadratic(const Point& p, const Point& q, const Point& r, std::vector<Piece>& out);
  /// Adds a cubic curve, exactly at degree 3 unless its derivative vanishes. Otherwise it becomes quadratics that have
  /// its tangents at their ends; their number grows as tolerance^(-1/4).
  void add_cubic(const std::array<Point, 4>& c, std::vector<Piece>& out);
  /// Adds the arc centre + u cos(t) + v sin(t), t from `from` to `from + sweep`, as pieces with its tangents at their
  /// ends.
  void add_arc(const Point& start, const Point& center, const Vector& u, const Vector& v, double from, double sweep,
               const Point& end, std::vector<Piece>& out);

  /// Upper bound of the distance, both ways, between any piece so far and the part of the outline that it stands for.
  double error() const { return error_; }

 private:
  void add_straight(const std::array<Point, 4>& c, std::vector<Piece>& out) const;
  void fit(const std::array<Point, 4>& c, int depth, std::vector<Piece>& out);

  int degree_;
  double tolerance_;
  bool follows_back_;
  double error_ = 0;
};

/// The two parts of a cubic at parameter t.
std::array<std::array<Point, 4>, 2> split(const std::array<Point, 4>& c, double t);

}  // namespace pliant::svg
