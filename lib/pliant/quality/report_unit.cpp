// lib/pliant/quality/report_unit.cpp: converts the figures of a scaled mesh to the units of its document.
#include <string_view>

#include "pliant/quality/metrics.h"
#include "pliant/quality/quality_report.h"

namespace pliant {
namespace {

double factor_of(std::string_view metric, double unit) { return unit_factor(find_metric(metric)->unit, unit); }

}  // namespace

void restore_unit(QualityReport& report, ElementFigures& elements, double unit) {
  if (unit == 1) return;
  const double unit_area = unit * unit;
  report.area *= unit_area;
  report.size *= unit;
  for (std::vector<BadElement>* list : {&report.invalid_elements, &report.degenerate_elements})
    for (BadElement& element : *list) element.centroid *= unit;
  for (OverlapPlace& overlap : report.overlap_places) overlap.place *= unit;
  for (FaceFigures& face : report.faces) {
    face.area *= unit_area;
    face.perimeter *= unit;
  }
  for (FieldFigures& field : report.fields)
    for (double& integral : field.integral) integral *= unit_area;
  for (MetricSummary& metric : report.metrics) {
    const double factor = factor_of(metric.name, unit);
    for (double* value : {&metric.min, &metric.max, &metric.mean, &metric.histogram_low, &metric.histogram_high})
      *value *= factor;
    for (WorstElement& element : metric.worst) {
      element.value *= factor;
      element.centroid *= unit;
    }
  }
  for (ElementColumn& column : elements.columns)
    if (const double factor = factor_of(column.name, unit); factor != 1)
      for (double& value : column.values) value *= factor;
}

}  // namespace pliant
