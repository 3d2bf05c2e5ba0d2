// lib/pliant/fem/navier_stokes/spline_weights.cpp: extracts splines with one control point that is not zero.
#include "pliant/fem/navier_stokes/spline_weights.h"

#include <algorithm>

#include "pliant/geometry/index.h"

namespace pliant {

SplineWeights::SplineWeights(const BSpline& spline)
    : unit_(spline), weights_(index(spline.degree()) + 1), extracted_(index(spline.degree()) + 1) {
  for (int i = 0; i < static_cast<int>(spline.points().size()); ++i) unit_.set_point(i, {0, 0});
}

void SplineWeights::set(double t0) {
  const int p = unit_.degree(), count = static_cast<int>(unit_.points().size());
  for (auto& each : weights_) each.clear();
  const int last = unit_.interval(t0);
  // A closed curve with few control points names one of them twice.
  for (int i = last - p; i <= std::min(last, last - p + count - 1); ++i) {
    const int coefficient = unit_.closed() ? (i % count + count) % count : i;
    unit_.set_point(coefficient, {1, 0});
    unit_.extract(t0, extracted_);
    unit_.set_point(coefficient, {0, 0});
    for (int k = 0; k <= p; ++k)
      if (extracted_[index(k)].x != 0) weights_[index(k)].push_back({coefficient, extracted_[index(k)].x});
  }
}

}  // namespace pliant
