// lib/pliant/quality/too_curved.h: when is an element too curved, and by how much (paper §5.3.4).
#pragma once
#include <span>

#include "pliant/geometry/point.h"

namespace pliant {

/// When is an element too curved? Every member is a bound; the defaults are those of smoothcurves.
struct CurvatureBounds {
  double max_distortion = 1.1;        ///< D above this
  double max_peak = 2.0;              ///< max(C) / 2A above this
  double min_shape_ratio = 0.5;       ///< curved tau below this times the logical triangle's |tau|
  double max_turning = 1.5707963268;  ///< an edge turns by more (radians)
  double min_scaled_jacobian = 0.3;   ///< the scaled Jacobian below this
};

/// From here on an element is not known to be valid; below, it is certified.
inline constexpr double tangled_excess = 1e6;

/// The test of many elements of one degree against the same bounds.
class CurvatureTest {
 public:
  CurvatureTest(int degree, const CurvatureBounds& bounds);

  /// A number above 1 says that the element is too curved, and by how much: the largest of the measures, each divided
  /// by its bound (the distortion above 1 by its bound above 1; for the shape and the scaled Jacobian the bound by the
  /// measure). Of an element whose curved shape is
  /// not proved positive it is tangled_excess (1 - shape): so all elements are in one order, the tangled ones by how
  /// far they are turned over. Infinite where control points are not finite. By how much an edge of `fixed` (bit k: the
  /// k-th) turns does not count.
  double excess(std::span<const Point> net, unsigned fixed = 0) const;
  /// excess(net) <= 1, at a fraction of the cost where the bounds hold well.
  bool is_fine(std::span<const Point> net) const { return is_surely_fine(net) || excess(net) <= 1; }
  /// Proves excess(net, fixed) <= 1 from the coefficients of det J, where these show it.
  bool is_surely_fine(std::span<const Point> net, unsigned fixed = 0) const;

 private:
  int degree_;
  CurvatureBounds bounds_;
  double least_cosine_;  // of the angle between two legs of an edge's polygon, for the edge to turn by no more
};

/// CurvatureTest of one element.
double curvature_excess(int degree, std::span<const Point> net, const CurvatureBounds& bounds);

}  // namespace pliant
