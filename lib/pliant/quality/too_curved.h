// lib/pliant/quality/too_curved.h: decides whether an element is too curved, and by how much (paper §5.3.4).
#pragma once
#include <numbers>
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// An element is too curved if one of its measures (element_quality.h) is beyond its bound here. The defaults are those
/// of smoothcurves.
struct CurvatureBounds {
  double max_distortion = 1.1;                       ///< greatest distortion D
  double max_peak = 2.0;                             ///< greatest jacobian_peak
  double min_shape_ratio = 0.5;                      ///< least curved shape, divided by |tau| of the logical triangle
  double max_turning = 90 * std::numbers::pi / 180;  ///< greatest angle by which an edge turns (radians)
  double min_scaled_jacobian = 0.3;                  ///< least scaled Jacobian
};

/// An element whose excess is at least this is not known to be valid; an element with less is certified.
inline constexpr double tangled_excess = 1e6;

/// Tests elements of one degree against the same bounds.
class CurvatureTest {
 public:
  CurvatureTest(int degree, const CurvatureBounds& bounds);

  /// How much too curved the element is: above 1 it is too curved. The excess is the largest of the measures, each
  /// divided by its bound; for the distortion, 1 is subtracted from both first; for the shape and the scaled Jacobian,
  /// the bound is divided by the measure. If the curved shape is not proved positive, the excess is
  /// tangled_excess (1 - shape), so that all elements are in one order, with tangled ones by how far they are inverted.
  /// It is infinite if control points are not finite. The turning of edge k does not count if bit k of `fixed` is set.
  double excess(std::span<const Point> net, unsigned fixed = 0) const;
  /// excess(net) <= 1, at a fraction of the cost if the bounds hold by far.
  bool is_fine(std::span<const Point> net) const {
    return is_nearly_straight(net) || is_surely_fine(net) || excess(net) <= 1;
  }
  /// True if the coefficients of det J suffice to prove excess(net, fixed) <= 1.
  bool is_surely_fine(std::span<const Point> net, unsigned fixed = 0) const;

 private:
  static double greatest_change(const CurvatureBounds& bounds);
  bool is_nearly_straight(std::span<const Point> net) const;

  int degree_;
  CurvatureBounds bounds_;
  // An edge turns by no more than its bound if no angle between consecutive legs of its polygon has a smaller cosine.
  double least_cosine_;
  double most_change_ =
      0;  // of a quadratic element's det J from that of its straight triangle, as a share of the latter
  double most_offset_ = 0;  // of the middle control point of a quadratic edge from the chord's middle, as a share of it
};

/// CurvatureTest::excess of one element.
double curvature_excess(int degree, std::span<const Point> net, const CurvatureBounds& bounds);

}  // namespace pliant
