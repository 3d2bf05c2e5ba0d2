// lib/pliant/quality/metrics.h: the one table of metrics for reports, conditions, tables, pages and pictures.
#pragma once
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/geometry/validity/validity.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {
struct ElementMeasures;

/// One metric of elements: what it is called, what it means, and which measure of an element it is.
struct Metric {
  enum class Unit { number, degrees, length, area };
  /// What the summary of a mesh is taken over.
  enum class Per {
    element,     ///< over the elements
    edge,        ///< over the edges, each once; the value of an element is its shortest edge
    table_entry  ///< there is no summary: the metric is for single elements only, in tables and pages
  };

  std::string_view name;   ///< the name in reports, conditions, tables and options
  std::string_view label;  ///< a word or two for people, where there is little room
  std::string_view title;  ///< the legend of a picture
  std::string_view text;   ///< what the metric is, in a sentence
  Unit unit;
  Per per;
  bool worst_is_least;
  double low, high;  ///< the range of a histogram; where a bound is NaN it is that of the values
  double ElementMeasures::*value;
};

/// All metrics, in the order of the columns of tables.
std::span<const Metric> all_metrics();
/// The metrics that a report sums up, in its order: all except those with Per::table_entry.
std::span<const Metric* const> report_metrics();
/// The metric of this name, among all or among those in a report; null if there is none.
const Metric* find_metric(std::string_view name);
const Metric* find_report_metric(std::string_view name);
/// The names of the report's metrics, with commas between them.
std::string_view metric_list();
/// "none", "degrees", "length" or "area".
std::string_view unit_name(Metric::Unit unit);
/// The factor by which a value grows if lengths grow by `factor`.
double unit_factor(Metric::Unit unit, double factor);

/// The value of the metric for each element, the same as in `report_quality`; NaN where there is none.
///
/// Requires    check_arrays(data) to be empty
std::vector<double> element_values(const MeshData& data, const Metric& metric);

/// Calls `take` for each element in order, with its certificate and its values of these metrics in their order; NaN
/// where there is none.
///
/// Requires    check_arrays(data) to be empty
void for_each_element(const MeshData& data, std::span<const Metric* const> metrics,
                      const std::function<void(TriangleId, Validity, std::span<const double>)>& take);

}  // namespace pliant
