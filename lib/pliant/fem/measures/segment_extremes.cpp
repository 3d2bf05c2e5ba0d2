// lib/pliant/fem/measures/segment_extremes.cpp: branch and bound on Bernstein coefficients, Newton's method at the end.
#include "pliant/fem/measures/segment_extremes.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

double evaluate(std::span<const double> coefficients, double s) {
  std::vector<double> basis(coefficients.size());
  bernstein_basis(static_cast<int>(coefficients.size()) - 1, s, basis);
  double value = 0;
  for (std::size_t k = 0; k < basis.size(); ++k) value += basis[k] * coefficients[k];
  return value;
}

std::vector<double> derivative_of(std::span<const double> coefficients) {
  std::vector<double> derivative(coefficients.size() - 1);
  differentiate_segment(static_cast<int>(coefficients.size()) - 1, coefficients, derivative);
  return derivative;
}

}  // namespace

void SegmentMaximum::raise(double value, std::size_t segment, double s) {
  if (!(value > value_)) return;
  value_ = value;
  segment_ = segment;
  s_ = s;
}

void SegmentMaximum::take_in(std::span<const double> coefficients, std::size_t segment) {
  std::vector<double> own(coefficients.begin(), coefficients.end());
  raise(own.front(), segment, 0);
  raise(own.back(), segment, 1);
  search(own, segment, 0, 1);
}

void SegmentMaximum::search(std::vector<double>& coefficients, std::size_t segment, double from, double to) {
  constexpr double shortest = 0x1p-30;  // there the coefficients are the values, to rounding
  if (!(*std::ranges::max_element(coefficients) > value_ + width_) || to - from < shortest) return;
  std::vector<double> left(coefficients.size());
  for (std::size_t k = 0; k < left.size(); ++k) {  // de Casteljau: `coefficients` becomes the right half
    left[k] = coefficients[0];
    for (std::size_t i = 0; i + k + 1 < left.size(); ++i) coefficients[i] = (coefficients[i] + coefficients[i + 1]) / 2;
  }
  const double middle = (from + to) / 2;
  raise(coefficients.front(), segment, middle);
  search(left, segment, from, middle);
  search(coefficients, segment, middle, to);
}

void SegmentMaximum::polish(std::span<const double> coefficients) {
  if (coefficients.size() < 3) return;
  const std::vector<double> slope = derivative_of(coefficients), bend = derivative_of(slope);
  constexpr int most_steps = 8;
  double s = s_;
  for (int k = 0; k < most_steps; ++k) {
    const double step = evaluate(slope, s) / evaluate(bend, s);
    if (!std::isfinite(step)) return;
    s = std::clamp(s - step, 0.0, 1.0);
  }
  const double value = evaluate(coefficients, s);
  if (std::abs(s - s_) > 1e-2 || value < value_ - width_) return;
  s_ = s;
  value_ = std::max(value, value_);
}

}  // namespace pliant
