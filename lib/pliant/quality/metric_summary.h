// lib/pliant/quality/metric_summary.h: sums a column of values up (private to this layer).
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "pliant/quality/metrics.h"
#include "pliant/quality/quality_report.h"

namespace pliant {

/// Sums up the values of one metric, some at a time; NaN stands for a value that does not exist. In the list of the
/// worst values, `triangle` is the position of the value among all that were added, and the first of equal values is
/// the worst; the caller replaces positions by triangles. Values are kept if `keeps_values`, or if the histogram has
/// no fixed range. A fixed range from 0 to 1 becomes -1 to 1 if there are negative values.
class Summariser {
 public:
  Summariser(const Metric& metric, int bins, int worst, bool keeps_values, std::size_t expected);
  void add(std::span<const double> values);
  MetricSummary finish();
  /// What was added, if values are kept.
  std::vector<double>& values() { return values_; }

 private:
  /// Equal bins over [low, high]; values outside fall into the outer bins.
  struct Histogram {
    double low = 0, high = 0;
    // Four counters for each bin: values that follow each other often fall into the same bin, and increments of one
    // counter would wait for each other.
    std::vector<std::array<std::int64_t, 4>> counts;
    void add(std::span<const double> values);
  };
  void see_worst(const std::pair<double, std::size_t>& entry);

  const Metric* metric_;
  int bins_;
  std::size_t most_;
  bool has_range_, keeps_values_;
  Histogram narrow_, wide_;  // over the fixed range, and over -1 to 1, which holds negative values too
  std::vector<double> values_;
  std::size_t count_ = 0;
  std::int64_t missing_ = 0;
  double min_ = HUGE_VAL, max_ = -HUGE_VAL;
  long double sum_ = 0;  // in long double the sum does not overflow
  // The worst values with their positions, the least bad on top. Values are negated if the largest are the worst.
  std::vector<std::pair<double, std::size_t>> heap_;
};

}  // namespace pliant
