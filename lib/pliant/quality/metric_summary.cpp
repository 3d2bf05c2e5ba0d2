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
  const double low = summary.histogram_low / 2, scale = per_width * bins;
  // Four counters a bin: values that follow each other are often in the same one, and each increment waits for the
  // last.
  std::vector<std::array<std::int64_t, 4>> counts(static_cast<std::size_t>(bins));
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k])) continue;
    const double place = std::clamp((values[k] / 2 - low) * scale, 0.0, static_cast<double>(bins - 1));
    ++counts[static_cast<std::size_t>(place)][k % 4];
  }
  for (std::size_t bin = 0; bin < counts.size(); ++bin)
    summary.histogram[bin] = counts[bin][0] + counts[bin][1] + counts[bin][2] + counts[bin][3];
}

/// Of finite values whose sum overflows.
double running_mean(std::span<const double> values) {
  double mean = 0, seen = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    ++seen;
    mean += value / seen - mean / seen;
  }
  return mean;
}

/// Least, greatest and sum of some values that are finite; without branches, four at a time.
struct Extent {
  double min, max, sum;
};
Extent extent_of(std::span<const double> values) {
  std::array<double, 4> min, max, sum{};
  min.fill(values[0]);
  max.fill(values[0]);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double value = values[k];
    min[k % 4] = value < min[k % 4] ? value : min[k % 4];
    max[k % 4] = value > max[k % 4] ? value : max[k % 4];
    sum[k % 4] += value;
  }
  return {std::min({min[0], min[1], min[2], min[3]}), std::max({max[0], max[1], max[2], max[3]}),
          sum[0] + sum[1] + (sum[2] + sum[3])};
}

/// The worst values, in a heap with the least bad of them on top.
class Worst {
 public:
  Worst(bool is_least, std::size_t most) : sign_(is_least ? 1 : -1), most_(most) {}
  bool might_take(double value) const {
    return heap_.size() < most_ || (most_ > 0 && sign_ * value <= heap_.front().first);
  }
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
  double sum = 0;
  constexpr std::size_t block_size = 512;  // summed by itself, which keeps the rounding small
  std::array<double, block_size> finite;
  for (std::size_t first = 0; first < values.size(); first += block_size) {
    std::span<const double> block = values.subspan(first, std::min(block_size, values.size() - first));
    const std::span<const double> all = block;
    if (const auto missing = std::ranges::count_if(all, [](double v) { return !std::isfinite(v); }); missing > 0) {
      summary.missing += missing;
      std::ranges::copy_if(all, finite.begin(), [](double v) { return std::isfinite(v); });
      block = std::span<const double>(finite).first(all.size() - static_cast<std::size_t>(missing));
      if (block.empty()) continue;
    }
    const Extent extent = extent_of(block);
    summary.min = std::min(summary.min, extent.min);
    summary.max = std::max(summary.max, extent.max);
    sum += extent.sum;
    if (!found.might_take(spec.worst_is_least ? extent.min : extent.max)) continue;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (std::isfinite(all[k])) found.see(all[k], first + k);
  }
  summary.count = static_cast<std::int64_t>(values.size()) - summary.missing;
  summary.mean = std::isfinite(sum) ? sum / static_cast<double>(summary.count) : running_mean(values);
  if (summary.count == 0) summary.min = summary.max = summary.mean = nan;
  if (bins > 0) fill_histogram(spec, values, bins, summary);
  for (const auto& [value, place] : found.sorted())
    summary.worst.push_back({static_cast<TriangleId>(place), value, {}});
  return summary;
}

}  // namespace pliant
