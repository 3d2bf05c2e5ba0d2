// lib/pliant/quality/metric_summary.h: from a column of values to its summary (private to this layer).
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

/// Sums up the values of one metric, some at a time (NaN: does not exist). Where the worst are is the caller's to say:
/// `triangle` is the place of the value among all, and of equal ones the first is the worst. A fixed range of the
/// histogram is widened where values lie outside it; for the others, and where `keeps_values`, values are kept.
class Summariser {
 public:
  Summariser(const Metric& metric, int bins, int worst, bool keeps_values, std::size_t expected);
  void add(std::span<const double> values);
  MetricSummary finish();
  /// What was added, if values are kept.
  std::vector<double>& values() { return values_; }

 private:
  /// Values in [low, high] fall into equal bins, what is outside into the outer ones.
  struct Histogram {
    double low = 0, high = 0;
    // Four counters a bin: values that follow each other are often in the same one, where each increment waits for the
    // last.
    std::vector<std::array<std::int64_t, 4>> counts;
    void add(std::span<const double> values);
  };
  void see_worst(const std::pair<double, std::size_t>& entry);

  const Metric* metric_;
  int bins_;
  std::size_t most_;
  bool has_range_, keeps_values_;
  Histogram narrow_, wide_;  // of a fixed range, and of the one that holds negative values too
  std::vector<double> values_;
  std::size_t count_ = 0;
  std::int64_t missing_ = 0;
  double min_ = HUGE_VAL, max_ = -HUGE_VAL;
  long double sum_ = 0;                               // which does not overflow
  std::vector<std::pair<double, std::size_t>> heap_;  // the worst, with the least bad of them on top; values signed
};

}  // namespace pliant
