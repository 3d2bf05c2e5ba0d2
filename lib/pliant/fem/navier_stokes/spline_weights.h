// lib/pliant/fem/navier_stokes/spline_weights.h: the Bézier points of a span as sums of a spline's control points.
#pragma once
#include <span>
#include <utility>
#include <vector>

#include "pliant/geometry/spline/bspline.h"

namespace pliant {

/// The extraction of a spline's spans (BSpline::extract) as weights. One object serves one span after the other.
class SplineWeights {
 public:
  explicit SplineWeights(const BSpline& spline);
  /// Finds the weights of the span that starts at the break t0.   Complexity O(degree^3 + log knots)
  void set(double t0);
  /// Which control points of the spline, with which weights, the k-th Bézier point is the sum of.
  std::span<const std::pair<int, double>> of(int k) const { return weights_[static_cast<std::size_t>(k)]; }

 private:
  BSpline unit_;  // the same knots; its control points are 0 but for those that are asked about
  std::vector<std::vector<std::pair<int, double>>> weights_;
  std::vector<Point> extracted_;
};

}  // namespace pliant
