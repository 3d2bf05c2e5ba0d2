#pragma once  // lib/pliant/quality/metric_summary.h: from a column of values to its summary (private to this layer)
#include <span>

#include "pliant/quality/quality_report.h"

namespace pliant {

/// How a metric is presented.
struct MetricSpec {
  const char* name;
  bool worst_is_least;
  double low, high;  ///< of the histogram; where a bound is NaN the data's own is taken
};
/// The metrics in the order of the report.
enum Metric {
  jacobian_metric,
  jacobian_max_metric,
  scaled_jacobian_metric,
  shape_metric,
  logical_tau_metric,
  control_tau_metric,
  distortion_metric,
  logical_angle_metric,
  turning_angle_metric,
  edge_length_metric,
  element_area_metric,
  metric_count
};
const MetricSpec& metric_spec(int metric);

/// The summary of these values (NaN: does not exist), but for where the worst are: `triangle` is the place of the value
/// in the column, and of equal ones the first is the worst. A fixed range of the histogram is widened where values lie
/// outside it.
MetricSummary summarise(const MetricSpec& spec, std::span<const double> values, int bins, int worst);

}  // namespace pliant
