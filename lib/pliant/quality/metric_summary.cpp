#include "pliant/quality/metric_summary.h"  // lib/pliant/quality/metric_summary.cpp

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace pliant {
namespace {

constexpr double of_data = std::numeric_limits<double>::quiet_NaN();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<MetricSpec, metric_count> specs{{{"jacobian", true, of_data, of_data},
                                                      {"jacobian_max", false, of_data, of_data},
                                                      {"scaled_jacobian", true, -1, 1},
                                                      {"shape", true, 0, 1},
                                                      {"logical_tau", true, 0, 1},
                                                      {"control_tau", true, 0, 1},
                                                      {"distortion", false, 1, of_data},
                                                      {"logical_angle", true, 0, 60},
                                                      {"turning_angle", false, 0, of_data},
                                                      {"edge_length", true, of_data, of_data},
                                                      {"element_area", true, of_data, of_data}}};

void fill_histogram(const MetricSpec& spec, std::span<const double> values, int bins, MetricSummary& summary) {
  summary.histogram.assign(static_cast<std::size_t>(bins), 0);
  summary.histogram_low = std::isnan(spec.low) ? summary.min : spec.low;
  summary.histogram_high = std::isnan(spec.high) ? summary.max : spec.high;
  // A tau or scaled Jacobian is at least -1; rounding may leave a range by a hair, which the outer bins take.
  if (spec.low == 0 && spec.high == 1 && summary.min < 0) summary.histogram_low = -1;
  summary.histogram_high = std::max(summary.histogram_high, summary.histogram_low);
  if (summary.count == 0) {
    if (std::isnan(summary.histogram_low)) summary.histogram_low = 0;
    if (std::isnan(summary.histogram_high)) summary.histogram_high = summary.histogram_low;
  }
  // Halves, for the whole width may overflow.
  const double half_width = summary.histogram_high / 2 - summary.histogram_low / 2;
  const double per_width = half_width > 0 ? 1 / half_width : 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    const double place = (value / 2 - summary.histogram_low / 2) * per_width;
    const auto bin = static_cast<std::ptrdiff_t>(std::clamp(place, 0.0, 1.0) * bins);
    ++summary.histogram[static_cast<std::size_t>(std::min<std::ptrdiff_t>(bin, bins - 1))];
  }
}

/// Summed in blocks, which keeps the rounding small.
double mean_of(std::span<const double> values, std::int64_t count) {
  constexpr std::size_t block = 1024;
  double sum = 0;
  for (std::size_t first = 0; first < values.size(); first += block) {
    double part = 0;
    for (const double value : values.subspan(first, std::min(block, values.size() - first)))
      part += std::isfinite(value) ? value : 0;
    sum += part;
  }
  if (std::isfinite(sum)) return sum / static_cast<double>(count);
  double mean = 0;  // of values so large that their sum overflows
  double seen = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    ++seen;
    mean += value / seen - mean / seen;
  }
  return mean;
}

/// The worst values, in a heap with the least bad of them on top.
class Worst {
 public:
  Worst(bool is_least, std::size_t most) : sign_(is_least ? 1 : -1), most_(most) {}
  void see(double value, std::size_t place) {
    const std::pair<double, std::size_t> entry{sign_ * value, place};
    if (heap_.size() == most_) {
      if (most_ == 0 || !(entry < heap_.front())) return;
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.pop_back();
    }
    heap_.push_back(entry);
    std::push_heap(heap_.begin(), heap_.end());
  }
  std::vector<std::pair<double, std::size_t>> sorted() {
    std::sort_heap(heap_.begin(), heap_.end());
    for (auto& entry : heap_) entry.first *= sign_;
    return std::move(heap_);
  }

 private:
  double sign_;
  std::size_t most_;
  std::vector<std::pair<double, std::size_t>> heap_;
};

}  // namespace

const MetricSpec& metric_spec(int metric) { return specs[static_cast<std::size_t>(metric)]; }

MetricSummary summarise(const MetricSpec& spec, std::span<const double> values, int bins, int worst) {
  MetricSummary summary;
  summary.name = spec.name;
  summary.min = HUGE_VAL;
  summary.max = -HUGE_VAL;
  Worst found(spec.worst_is_least, static_cast<std::size_t>(std::max(worst, 0)));
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double value = values[k];
    if (!std::isfinite(value)) {
      ++summary.missing;
      continue;
    }
    summary.min = std::min(summary.min, value);
    summary.max = std::max(summary.max, value);
    found.see(value, k);
  }
  summary.count = static_cast<std::int64_t>(values.size()) - summary.missing;
  summary.mean = mean_of(values, summary.count);
  if (summary.count == 0) summary.min = summary.max = summary.mean = nan;
  if (bins > 0) fill_histogram(spec, values, bins, summary);
  for (const auto& [value, place] : found.sorted())
    summary.worst.push_back({static_cast<TriangleId>(place), value, {}});
  return summary;
}

}  // namespace pliant
