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

inline constexpr int max_curve_degree = 16;  ///< of a B-spline

/// A B-spline curve.
///
/// Open:   points + degree + 1 knots, clamped (end knots of multiplicity degree + 1).
/// Closed: m control points and m + 1 knots, one period; basis function i starts at knot i, knots continued
///         periodically (knot(i + m) = knot(i) + period), nothing repeated; m >= degree.
/// Interior knots have multiplicity 1..degree. A *break* is a distinct knot value; a *span* is a non-empty knot
/// interval, counted from 0 along [first_parameter, last_parameter]. On a closed curve the breaks are those in
/// [first, first + period), so breaks = spans; on an open one breaks = spans + 1.
class BSpline {
 public:
  BSpline() = default;
  /// Requires what `fault()` checks.
  BSpline(int degree, bool closed, std::vector<double> knots, std::vector<Point> points);
  /// Why these members are not a B-spline as above (in words that open with the place, for example "knots/7 is 2, but
  /// knots/6 is 3: knots do not decrease"); empty if they are. Also checks finiteness, counts, clamping,
  /// multiplicities.
  static std::optional<std::string> fault(int degree, bool closed, std::span<const double> knots,
                                          std::span<const Point> points);

  int degree() const { return degree_; }
  bool closed() const { return closed_; }
  const Sequence<double>& knots() const { return knots_; }
  const Sequence<Point>& points() const { return points_; }

  double first_parameter() const;
  double last_parameter() const;
  double period() const { return last_parameter() - first_parameter(); }
  /// Knot i of the infinite (closed) or stored (open) sequence.
  double knot(int i) const;
  /// The greatest i (stored; open: below the last non-empty span's end) with knot(i) <= t: control points i - degree to
  /// i, on a closed curve continued periodically, are those that matter at t.   Complexity O(log knots)
  int interval(double t) const;

  /// How many spans there are; counts no further than `most`.   Complexity O(min(knots, most * degree))
  int span_count(int most = std::numeric_limits<int>::max()) const;
  /// All breaks in ascending order: span s is [breaks[s], breaks[s + 1]]; span_count() + 1 values (closed: the last is
  /// the first plus the period).   Complexity O(knots)
  std::vector<double> breaks() const;
  /// The end t1 of the span that starts at the break t0.   Complexity O(log knots)
  double span_end(double t0) const;
  /// The start of the span that ends at break t1 (closed: continued periodically below the first break, returned in
  /// [first, last)).
  double span_before(double t1) const;
  /// Multiplicity of the break t (0 if t is no knot); closed: counted round the seam.
  int multiplicity(double t) const;

  /// Value and derivative (with respect to the parameter) by de Boor; t in [first, last]; the derivative at a break is
  /// from the right unless `from_left`.
  Point evaluate(double t) const;
  Vector derivative(double t, bool from_left = false) const;

  /// Bézier control points (degree + 1) of the span that starts at break t0. Open end points and values at knots of
  /// multiplicity `degree` are copied bit for bit, and the end of one span equals the start of the next bit for bit.
  void extract(double t0, std::span<Point> out) const;

  /// One change of one knot or control point: enough to take it back bit for bit. Changes note theirs in a list.
  struct Edit {
    enum class Kind : std::uint8_t { set_point, insert_point, erase_point, set_knot, insert_knot, erase_knot };
    Kind kind;
    int index;
    Point old;  ///< what was there; a knot is its x
  };
  using Edits = std::vector<Edit>;
  /// Requires that nothing has changed since.
  void take_back(const Edit& edit);
  /// Moves one control point (the seam of a closed curve needs nothing special: points are not repeated).
  void set_point(int i, const Point& p, Edits* edits = nullptr);

  /// Adds factor times the vectors of `other` to the control points.   Requires    the same knots
  void add(const BSpline& other, double factor);

  /// Inserts t (once more): shape unchanged. Requires first < t < last or closed; multiplicity < degree after.
  /// Complexity O(degree^2), and what an insertion into a Sequence costs
  void insert_knot(double t, Edits* edits = nullptr);
  /// Removes break t once; `error` is a bound of the distance between old and new curve (largest movement of a control
  /// point in the old knots: exact bound by the partition of unity). The new control points minimise it in the
  /// least-squares sense. Empty, curve unchanged, when refused (end of an open curve, fewer than degree points left on
  /// a closed one, no knot at t). Only degree - multiplicity control points change. When the first break of a closed
  /// curve loses its last knot, the next break becomes the first one (the period stays).
  /// Complexity O(degree^2), and what an erasure from a Sequence costs
  std::optional<double> remove_knot(double t, Edits* edits = nullptr);
  /// The error that remove_knot(t) would return, curve unchanged.   Complexity O(degree^2 + log knots), no allocation
  std::optional<double> removal_error(double t) const;
  /// Removes break t altogether (all its multiplicity); the bound is the sum. Refuses as above, curve unchanged.
  std::optional<double> remove_break(double t, Edits* edits = nullptr);

  /// The Greville abscissae: mean of degree consecutive knots; one for each control point (closed: reduced to the
  /// period).
  std::vector<double> greville() const;
  /// Replaces the control points so that the curve interpolates values[i] at greville()[i] (banded solve; cyclic for
  /// closed curves). False, curve unchanged, if the system is singular.   Complexity O(points * degree^2)
  bool interpolate(std::span<const Point> values);

  /// The same curve at degree + 1 (every break's multiplicity grows by one); open ends stay bit for bit.
  BSpline elevated() const;
  /// Area swept by the span that starts at break t0 as seen from `origin`, as `area` says.   Complexity O(degree^3)
  double swept_area(double t0, const Point& origin) const;
  /// Signed area swept: half the integral of x dy - y dx, exact to rounding (for closed curves the enclosed area).
  double area() const;
  double area(const Point& origin) const;  ///< swept as seen from there
  double arc_length() const;               ///< to 1e-12 relative on tame curves, by Gauss rules on halved spans

 private:
  void insert_point(int i, Edits* edits);
  void erase_point(int i, Edits* edits);
  void erase_knot(int i, Edits* edits);
  struct KnotRemoval {
    int knot, multiplicity, first, count;  ///< index of the knot; its copies; of the first new control point; how many
    std::array<Point, max_curve_degree + 1> points;  ///< those that will be there
    double error;
  };
  /// A removal of t; empty where remove_knot refuses.
  std::optional<KnotRemoval> plan_removal(double& t) const;
  /// Control point i, periodically continued on a closed curve.
  const Point& point(int i) const;
  /// Greville abscissa i, on a closed curve not reduced to the period: between knots i + 1 and i + degree.
  double unreduced_greville(int i) const;
  /// The blossom at `degree` ascending arguments that contain every knot strictly between their ends.
  Point blossom(std::span<const double> arguments) const;

  int degree_ = 0;
  bool closed_ = false;
  Sequence<double> knots_;
  Sequence<Point> points_;
};

}  // namespace pliant
