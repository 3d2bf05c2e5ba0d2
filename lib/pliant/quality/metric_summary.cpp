#include "pliant/quality/metric_summary.h"  // lib/pliant/quality/metric_summary.cpp

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pliant {
namespace {

constexpr double of_data = std::numeric_limits<double>::quiet_NaN();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<MetricSpec, metric_count> specs{{{"jacobian", true, of_data, of_data},
                                                      {"scaled_jacobian", true, -1, 1},
                                                      {"shape", true, 0, 1},
                                                      {"logical_tau", true, 0, 1},
                                                      {"control_tau", true, 0, 1},
                                                      {"distortion", false, 1, of_data},
                                                      {"logical_angle", true, 0, 60},
                                                      {"turning_angle", false, 0, of_data},
                                                      {"edge_length", true, of_data, of_data},
                                                      {"element_area", true, of_data, of_data}}};

void fill_histogram(const MetricSpec& spec, const MetricColumn& column, int bins, MetricSummary& summary) {
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
  for (const double value : column.values) {
    if (!std::isfinite(value)) continue;
    const double place = half_width > 0 ? (value / 2 - summary.histogram_low / 2) / half_width : 0;
    const auto bin = static_cast<std::ptrdiff_t>(std::clamp(place, 0.0, 1.0) * bins);
    ++summary.histogram[static_cast<std::size_t>(std::min<std::ptrdiff_t>(bin, bins - 1))];
  }
}

}  // namespace

const MetricSpec& metric_spec(int metric) { return specs[static_cast<std::size_t>(metric)]; }

MetricSummary summarise(const MetricSpec& spec, const MetricColumn& column, int bins, int worst) {
  MetricSummary summary;
  summary.name = spec.name;
  summary.min = HUGE_VAL;
  summary.max = -HUGE_VAL;
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < column.values.size(); ++k) {
    const double value = column.values[k];
    if (!std::isfinite(value)) {
      ++summary.missing;
      continue;
    }
    order.push_back(k);
    summary.min = std::min(summary.min, value);
    summary.max = std::max(summary.max, value);
    summary.mean += (value - summary.mean) / static_cast<double>(++summary.count);
  }
  if (summary.count == 0) summary.min = summary.max = summary.mean = nan;
  if (bins > 0) fill_histogram(spec, column, bins, summary);
  const auto shown = static_cast<std::ptrdiff_t>(std::min(order.size(), static_cast<std::size_t>(std::max(worst, 0))));
  std::partial_sort(order.begin(), order.begin() + shown, order.end(), [&](std::size_t a, std::size_t b) {
    const double x = column.values[a], y = column.values[b];
    if (x != y) return spec.worst_is_least ? x < y : x > y;
    return column.triangles[a] < column.triangles[b];
  });
  for (std::ptrdiff_t k = 0; k < shown; ++k) {
    const std::size_t n = order[static_cast<std::size_t>(k)];
    summary.worst.push_back({column.triangles[n], column.values[n], {}});
  }
  return summary;
}

}  // namespace pliant
