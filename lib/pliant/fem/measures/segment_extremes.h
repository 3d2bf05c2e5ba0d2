// lib/pliant/fem/measures/segment_extremes.h: the greatest value of polynomials on segments.
#pragma once
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace pliant {

/// The greatest value of many polynomials on [0, 1] in Bernstein form, found by halving what may still be above it.
class SegmentMaximum {
 public:
  /// Values that are above the one that is found by no more than `width` may be missed.
  explicit SegmentMaximum(double width) : width_(width) {}

  /// Takes in the polynomial with these coefficients; `segment` is its number.
  void take_in(std::span<const double> coefficients, std::size_t segment);
  /// Moves s to the nearest place where the derivative vanishes, to rounding, if that is no worse: a value that is
  /// right to `width` leaves its place uncertain by the root of it. Requires    the coefficients of segment()
  void polish(std::span<const double> coefficients);

  double value() const { return value_; }
  std::size_t segment() const { return segment_; }
  double s() const { return s_; }

 private:
  void raise(double value, std::size_t segment, double s);
  void search(std::vector<double>& coefficients, std::size_t segment, double from, double to);

  double width_, value_ = -std::numeric_limits<double>::infinity(), s_ = 0;
  std::size_t segment_ = 0;
};

}  // namespace pliant
