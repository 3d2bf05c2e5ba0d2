// lib/pliant/quality/metrics.cpp: the table of metrics, and its look-up by name.
#include "pliant/quality/metrics.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>

#include "pliant/geometry/index.h"
#include "pliant/quality/element/element_measures.h"
#include "pliant/quality/quality_report.h"

namespace pliant {
namespace {

constexpr double of_data = std::numeric_limits<double>::quiet_NaN();  // the histogram takes the bound of the values
using Unit = Metric::Unit;
using Per = Metric::Per;

constexpr std::array<Metric, 12> table{{
    {"jacobian", "least det J", "least det J of the element",
     "A guaranteed lower bound of the Jacobian determinant; positive on every valid element.", Unit::area, Per::element,
     true, of_data, of_data, &ElementMeasures::jacobian},
    {"jacobian_max", "greatest det J", "largest det J of the element",
     "A guaranteed upper bound of the Jacobian determinant.", Unit::area, Per::element, false, of_data, of_data,
     &ElementMeasures::jacobian_max},
    {"scaled_jacobian", "scaled Jacobian", "scaled Jacobian",
     "Least over greatest absolute det J: 1 where it is constant, negative where the element folds.", Unit::number,
     Per::element, true, -1, 1, &ElementMeasures::scaled_jacobian},
    {"shape", "shape τ", "least shape τ of the element",
     "Guaranteed least τ on the element: 1 if everywhere like an equilateral triangle, 0 if flat.", Unit::number,
     Per::element, true, 0, 1, &ElementMeasures::shape},
    {"logical_tau", "logical τ", "shape τ of the logical triangle", "τ of the straight triangle on the corners.",
     Unit::number, Per::element, true, 0, 1, &ElementMeasures::logical_tau},
    {"control_tau", "control-net τ", "least shape τ of the control net",
     "Least τ of the straight triangles of the control net.", Unit::number, Per::element, true, 0, 1,
     &ElementMeasures::control_tau},
    {"distortion", "distortion D", "distortion D",
     "Mean square of det J over its squared mean: 1 if det J is constant.", Unit::number, Per::element, false, 1,
     of_data, &ElementMeasures::distortion},
    {"logical_angle", "least angle", "least logical angle, degrees",
     "Least angle of the straight triangle on the corners.", Unit::degrees, Per::element, true, 0, 60,
     &ElementMeasures::logical_angle},
    {"turning_angle", "turning angle", "largest turning of an edge, degrees",
     "The most that the control polygon of an edge turns.", Unit::degrees, Per::element, false, 0, of_data,
     &ElementMeasures::turning_angle},
    {"edge_length", "shortest edge", "length of the shortest edge", "Arc length of the shortest edge.", Unit::length,
     Per::edge, true, of_data, of_data, &ElementMeasures::shortest_edge},
    {"edge_length_max", "longest edge", "length of the longest edge", "Arc length of the longest edge.", Unit::length,
     Per::table_entry, false, of_data, of_data, &ElementMeasures::longest_edge},
    {"element_area", "area", "element area", "Signed area of the element.", Unit::area, Per::element, true, of_data,
     of_data, &ElementMeasures::area},
}};

}  // namespace

std::span<const Metric> all_metrics() { return table; }

std::span<const Metric* const> report_metrics() {
  static const std::vector<const Metric*> metrics = [] {
    std::vector<const Metric*> list;
    for (const Metric& metric : table)
      if (metric.per != Per::table_entry) list.push_back(&metric);
    return list;
  }();
  return metrics;
}

const Metric* find_metric(std::string_view name) {
  const auto found = std::ranges::find(table, name, &Metric::name);
  return found == table.end() ? nullptr : &*found;
}

const Metric* find_report_metric(std::string_view name) {
  const Metric* metric = find_metric(name);
  return metric != nullptr && metric->per != Per::table_entry ? metric : nullptr;
}

std::string_view metric_list() {
  static const std::string list = [] {
    std::string names;
    for (const Metric* metric : report_metrics()) names.append(names.empty() ? "" : ", ").append(metric->name);
    return names;
  }();
  return list;
}

std::string_view unit_name(Unit unit) {
  constexpr std::array<std::string_view, 4> names{"none", "degrees", "length", "area"};
  return names[index(static_cast<int>(unit))];
}

double unit_factor(Unit unit, double factor) {
  if (unit == Unit::area) return factor * factor;
  return unit == Unit::length ? factor : 1;
}

void for_each_element(const MeshData& data, std::span<const Metric* const> metrics,
                      const std::function<void(TriangleId, Validity, std::span<const double>)>& take) {
  std::vector<TriangleId> elements(data.triangle_faces.size());
  std::iota(elements.begin(), elements.end(), 0);
  std::vector<double> values(metrics.size());
  measure_elements(data, elements, QualityOptions().jacobian_width,
                   [&](std::size_t first, std::span<const ElementMeasures> measures) {
                     for (const ElementMeasures& of_element : measures) {
                       for (std::size_t m = 0; m < metrics.size(); ++m) values[m] = of_element.*metrics[m]->value;
                       take(elements[first++], of_element.validity, values);
                     }
                   });
}

std::vector<double> element_values(const MeshData& data, const Metric& metric) {
  std::vector<double> values;
  values.reserve(data.triangle_faces.size());
  for_each_element(data, std::array{&metric},
                   [&](TriangleId, Validity, std::span<const double> value) { values.push_back(value[0]); });
  return values;
}

}  // namespace pliant
