// lib/pliant/geometry/spline/bspline.h: planar B-spline curves of any degree, open (clamped) and closed.
#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pliant/geometry/point.h"
#include "pliant/geometry/sequence.h"

namespace pliant {

inline constexpr int max_curve_degree = 16;  ///< the greatest degree of a B-spline

/// A B-spline curve.
///
/// Open    m control points and m + degree + 1 knots; clamped: each end knot
///         has multiplicity degree + 1.
/// Closed  m >= degree control points, none repeated, and m + 1 knots, which
///         span one period. Basis function i starts at knot i, and the knots
///         continue periodically: knot(i + m) = knot(i) + period.
///
/// Interior knots have multiplicity 1..degree. A *break* is a distinct knot value; a *span* is a non-empty knot
/// interval. Spans are counted from 0 along [first_parameter, last_parameter]. An open curve has one break more than
/// spans; on a closed one the last break is the first one, a period later.
class BSpline {
 public:
  BSpline() = default;
  /// Requires    fault() finds nothing
  BSpline(int degree, bool closed, std::vector<double> knots, std::vector<Point> points);
  /// Why these members are not a B-spline as described above, in words that open with the place (for example "knots/7
  /// is 2, but knots/6 is 3: knots do not decrease"); empty if they are one. Checked are counts, finiteness, order,
  /// clamping and multiplicities.
  static std::optional<std::string> fault(int degree, bool closed, std::span<const double> knots,
                                          std::span<const Point> points);

  int degree() const { return degree_; }
  bool closed() const { return closed_; }
  const Sequence<double>& knots() const { return knots_; }
  const Sequence<Point>& points() const { return points_; }

  double first_parameter() const;
  double last_parameter() const;
  double period() const { return last_parameter() - first_parameter(); }
  /// Knot i of the stored knots, on a closed curve of their periodic continuation.
  double knot(int i) const;
  /// The index i of the knot at which the span that contains t starts: the last knot with knot(i) <= t, or, where an
  /// open curve ends, the start of the last span. The control points that matter at t are i - degree to i, on a closed
  /// curve continued periodically.   Complexity O(log knots)
  int interval(double t) const;

  /// How many spans there are; counts no further than `most`.   Complexity O(min(knots, most * degree))
  int span_count(int most = std::numeric_limits<int>::max()) const;
  /// All breaks in ascending order, span_count() + 1 values; span s is [breaks[s], breaks[s + 1]].
  /// Complexity O(knots)
  std::vector<double> breaks() const;
  /// The end t1 of the span that starts at the break t0.   Complexity O(log knots)
  double span_end(double t0) const;
  /// The start of the span that ends at the break t1. On a closed curve the last span is before the first break.
  double span_before(double t1) const;
  /// Multiplicity of the break t (0 if t is no knot). On a closed curve the seam's copies at both ends are counted.
  int multiplicity(double t) const;

  /// Value and derivative with respect to the parameter, by de Boor, for t in [first, last]. At a break the derivative
  /// is the one from the right unless `from_left`.
  Point evaluate(double t) const;
  Vector derivative(double t, bool from_left = false) const;

  /// Bézier control points (degree + 1) of the span that starts at the break t0. At an end of an open curve and at a
  /// knot of multiplicity `degree` the control point is copied bit for bit. The end of one span equals the start of the
  /// next one bit for bit.
  void extract(double t0, std::span<Point> out) const;

  /// One change of one knot or control point, with what is needed to take it back bit for bit. The functions that
  /// change a curve append their edits to a list.
  struct Edit {
    enum class Kind : std::uint8_t { set_point, insert_point, erase_point, set_knot, insert_knot, erase_knot };
    Kind kind;
    int index;
    Point old;  ///< the control point that was there, or the knot as its x
  };
  using Edits = std::vector<Edit>;
  /// Undoes one edit.   Requires    all later edits have been taken back
  void take_back(const Edit& edit);
  /// Moves one control point.
  void set_point(int i, const Point& p, Edits* edits = nullptr);

  /// Adds factor times the vectors of `other` to the control points.   Requires    the same knots
  void add(const BSpline& other, double factor);

  /// Inserts the knot t, once more if there is one; the curve keeps its shape.
  /// Requires    first < t < last on an open curve; t has a multiplicity below the degree
  /// Complexity  O(degree^2), and what an insertion into a Sequence costs
  void insert_knot(double t, Edits* edits = nullptr);
  /// Removes one copy of the knot t. Inserting t again would bring the control points back to their old places as
  /// nearly as possible (in the least-squares sense). Only degree - multiplicity of them change. When the first break
  /// of a closed curve loses its last copy, the next break becomes the first one; the period stays.
  ///
  /// Returns     a bound of the distance between the old and the new curve: how far the farthest control point would be
  ///             from its old place (a bound, because basis functions are not negative and sum to 1)
  /// Refuses     an end of an open curve; a t that is no knot; a closed curve that would keep fewer than `degree`
  ///             control points. The result is then empty, and the curve is unchanged.
  /// Complexity  O(degree^2), and what an erasure from a Sequence costs
  std::optional<double> remove_knot(double t, Edits* edits = nullptr);
  /// What remove_knot(t) would return; the curve is unchanged.   Complexity O(degree^2 + log knots), no allocation
  std::optional<double> removal_error(double t) const;
  /// Removes all copies of the knot t, and returns the sum of the bounds. Refuses like remove_knot.
  std::optional<double> remove_break(double t, Edits* edits = nullptr);

  /// An estimate of how far the span that starts at t0 is from the smooth curve that the spline stands for, such as the
  /// exact motion of an interface, if splines of this degree can only follow it span by span.
  ///
  /// A smooth curve's derivative of order degree + 1 shows in the spline as jumps of the derivative of order degree at
  /// the knots. The sum of the jumps around the span over the stretch of parameters that they stand for, times
  /// h^(degree + 1), times Favard's constant for the interpolation by splines of equal spans, is the error. It is at
  /// least that of an arc of a circle which turns as the span does: this tells it also for spans without neighbours.
  /// Jumps at knots of higher multiplicity do not count: there the curve is less smooth on purpose.
  ///
  /// Units       length; it scales with the points and does not depend on the scale of the knots
  /// Complexity  O(degree^2 + log knots), no allocation
  double resolution_error(double t0) const;

  /// The Greville abscissae, one for each control point: the means of `degree` consecutive knots, on a closed curve
  /// moved into the period.
  std::vector<double> greville() const;
  /// Replaces the control points so that the curve interpolates values[i] at greville()[i] (banded solve; cyclic for
  /// closed curves). False, curve unchanged, if the system is singular.   Complexity O(points * degree^2)
  bool interpolate(std::span<const Point> values);

  /// The same curve at degree + 1, where every break has one copy more. The ends of an open curve stay bit for bit.
  BSpline elevated() const;
  /// The part of area(origin) that belongs to the span that starts at the break t0.   Complexity O(degree^3)
  double swept_area(double t0, const Point& origin) const;
  /// The signed area that the curve sweeps as seen from the origin of the plane: half the integral of x dy - y dx,
  /// exact to rounding. On a closed curve it is the enclosed area.
  double area() const;
  double area(const Point& origin) const;  ///< the same as seen from another place
  /// The length of the curve, by Gauss rules on spans that are halved as needed: right to 1e-12 of it, unless the curve
  /// nearly stops somewhere.
  double arc_length() const;

 private:
  /// The derivative of order degree on the interval from knot k to the next, where it is constant.
  Vector highest_derivative(int k) const;
  void insert_point(int i, Edits* edits);
  void erase_point(int i, Edits* edits);
  void erase_knot(int i, Edits* edits);
  struct KnotRemoval {
    int knot, multiplicity;                          ///< the index of the knot that goes; how many copies there are
    int first, count;                                ///< the index of the first new control point; how many there are
    std::array<Point, max_curve_degree + 1> points;  ///< the new control points
    double error;
  };
  /// How to remove t; empty where remove_knot refuses. Sets t to first_parameter() if it is the end of a closed curve.
  std::optional<KnotRemoval> plan_removal(double& t) const;
  /// Control point i, periodically continued on a closed curve.
  const Point& point(int i) const;
  /// Greville abscissa i, on a closed curve not reduced to the period: between knots i + 1 and i + degree.
  double unreduced_greville(int i) const;
  /// The blossom at `degree` ascending arguments.   Requires    every knot strictly between their ends is among them
  Point blossom(std::span<const double> arguments) const;

  int degree_ = 0;
  bool closed_ = false;
  Sequence<double> knots_;
  Sequence<Point> points_;
};

}  // namespace pliant
