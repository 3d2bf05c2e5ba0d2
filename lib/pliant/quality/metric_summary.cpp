// lib/pliant/quality/metric_summary.cpp: extremes, sums, histograms and the worst values, block by block.
#include "pliant/quality/metric_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "pliant/quality/nan.h"

namespace pliant {
namespace {

/// The least, the greatest and the sum of some finite values; computed four at a time, without branches.
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

}  // namespace

void Summariser::Histogram::add(std::span<const double> values) {
  // Halves are used since the whole width may overflow.
  const double half_width = high / 2 - low / 2, half_low = low / 2;
  const double scale = half_width > 0 ? static_cast<double>(counts.size()) / half_width : 0;
  const double last = static_cast<double>(counts.size() - 1);
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k])) continue;
    const double place = std::clamp((values[k] / 2 - half_low) * scale, 0.0, last);
    ++counts[static_cast<std::size_t>(place)][k % 4];
  }
}

Summariser::Summariser(const Metric& metric, int bins, int worst, bool keeps_values, std::size_t expected)
    : metric_(&metric),
      bins_(std::max(bins, 0)),
      most_(static_cast<std::size_t>(std::max(worst, 0))),
      has_range_(!std::isnan(metric.low) && !std::isnan(metric.high)),
      keeps_values_(keeps_values || (bins_ > 0 && !has_range_)) {
  if (keeps_values_) values_.reserve(expected);
  if (!has_range_ || bins_ == 0) return;
  narrow_ = {metric.low, metric.high, std::vector<std::array<std::int64_t, 4>>(static_cast<std::size_t>(bins_))};
  // A shape (tau) may be negative, but is at least -1.
  if (metric.low == 0 && metric.high == 1) wide_ = {-1, 1, narrow_.counts};
}

void Summariser::add(std::span<const double> values) {
  const std::size_t first = count_;
  count_ += values.size();
  if (keeps_values_) values_.insert(values_.end(), values.begin(), values.end());
  if (has_range_ && bins_ > 0) {
    narrow_.add(values);
    if (!wide_.counts.empty()) wide_.add(values);
  }
  constexpr std::size_t block_size = 512;  // each block is summed by itself, which keeps rounding errors small
  std::array<double, block_size> finite;
  for (std::size_t done = 0; done < values.size(); done += block_size) {
    const std::span<const double> all = values.subspan(done, std::min(block_size, values.size() - done));
    std::span<const double> block = all;
    if (const auto missing = std::ranges::count_if(all, [](double v) { return !std::isfinite(v); }); missing > 0) {
      missing_ += missing;
      std::ranges::copy_if(all, finite.begin(), [](double v) { return std::isfinite(v); });
      block = std::span<const double>(finite).first(all.size() - static_cast<std::size_t>(missing));
      if (block.empty()) continue;
    }
    const Extent extent = extent_of(block);
    min_ = std::min(min_, extent.min);
    max_ = std::max(max_, extent.max);
    sum_ += std::isfinite(extent.sum) ? extent.sum : std::accumulate(block.begin(), block.end(), 0.0L);
    const double sign = metric_->worst_is_least ? 1 : -1;
    const double worst_here = sign * (metric_->worst_is_least ? extent.min : extent.max);
    if (most_ == 0 || (heap_.size() == most_ && worst_here >= heap_.front().first)) continue;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (std::isfinite(all[k])) see_worst({sign * all[k], first + done + k});
  }
}

void Summariser::see_worst(const std::pair<double, std::size_t>& entry) {
  if (heap_.size() == most_) {
    if (!(entry < heap_.front())) return;
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
  }
  heap_.push_back(entry);
  std::push_heap(heap_.begin(), heap_.end());
}

MetricSummary Summariser::finish() {
  MetricSummary summary;
  summary.name = metric_->name;
  summary.missing = missing_;
  summary.count = static_cast<std::int64_t>(count_) - missing_;
  const bool is_empty = summary.count == 0;
  summary.min = is_empty ? nan : min_;
  summary.max = is_empty ? nan : max_;
  summary.mean = is_empty ? nan : static_cast<double>(sum_ / static_cast<long double>(summary.count));
  if (bins_ > 0) {
    Histogram& histogram = !wide_.counts.empty() && min_ < 0 ? wide_ : narrow_;
    if (!has_range_) {
      const auto bound = [&](double fixed, double of_values) { return std::isnan(fixed) ? of_values : fixed; };
      histogram.low = bound(metric_->low, is_empty ? 0 : min_);
      histogram.high = std::max(bound(metric_->high, is_empty ? histogram.low : max_), histogram.low);
      histogram.counts.resize(static_cast<std::size_t>(bins_));
      histogram.add(values_);
    }
    summary.histogram_low = histogram.low;
    summary.histogram_high = histogram.high;
    for (const auto& parts : histogram.counts) summary.histogram.push_back(parts[0] + parts[1] + parts[2] + parts[3]);
  }
  std::sort_heap(heap_.begin(), heap_.end());
  for (const auto& [value, place] : heap_)
    summary.worst.push_back({static_cast<TriangleId>(place), metric_->worst_is_least ? value : -value, {}});
  return summary;
}

}  // namespace pliant
