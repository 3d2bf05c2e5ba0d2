// lib/pliant/quality/metrics.h: the table of metrics that reports, conditions, tables, pages and pictures share.
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "pliant/mesh/mesh_data.h"

namespace pliant {
struct ElementMeasures;

/// One metric of elements: what it is called, what it means, and which of an element's measures it is.
struct Metric {
  enum class Unit { number, degrees, length, area };
  /// What the values of a mesh are counted over.
  enum class Per {
    element,
    edge,        ///< of a mesh each edge counts once, of an element its shortest edge is the value
    table_entry  ///< a value of elements in tables and pages; meshes have no summary of it
  };

  std::string_view name;   ///< in reports, conditions, tables and options
  std::string_view label;  ///< a word or two for people, where there is little room
  std::string_view title;  ///< for the legend of a picture
  std::string_view text;   ///< a sentence
  Unit unit;
  Per per;
  bool worst_is_least;
  double low, high;  ///< of a histogram; where a bound is NaN the data's own is taken
  double ElementMeasures::*value;
};

/// All metrics, in the order of the columns of tables.
std::span<const Metric> all_metrics();
/// Those that a report sums up, in its order: all but those that only tables have.
std::span<const Metric* const> report_metrics();
/// The metric of that name, of all or of those in a report; null if there is none.
const Metric* find_metric(std::string_view name);
const Metric* find_report_metric(std::string_view name);
/// The names of the report's metrics, with commas between them.
std::string_view metric_list();
/// "none", "degrees", "length" or "area".
std::string_view unit_name(Metric::Unit unit);
/// By what a value grows where lengths grow by `factor`.
double unit_factor(Metric::Unit unit, double factor);

/// The metric's value for each element, as `report_quality` has it; NaN where there is none.
/// Requires    check_arrays(data) to be empty
std::vector<double> element_values(const MeshData& data, const Metric& metric);

}  // namespace pliant
