#pragma once  // lib/pliant/quality/metric_summary.h: from a column of values to its summary (private to this layer)
#include <string>
#include <vector>

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

/// The values of one metric, each of a triangle.
struct MetricColumn {
  std::vector<double> values;  ///< NaN: does not exist
  std::vector<TriangleId> triangles;
  void add(TriangleId t, double value) {
    values.push_back(value);
    triangles.push_back(t);
  }
};
/// All but the places of the worst. A fixed range of the histogram is widened where values lie outside it.
MetricSummary summarise(const MetricSpec& spec, const MetricColumn& column, int bins, int worst);

}  // namespace pliant
