// formats/report/report_json.cpp: members in the order of formats/report.md.
#include "formats/report/report_json.h"

#include <cmath>

#include "formats/document/write_json.h"

namespace pliant {
namespace {

void write_value(JsonWriter& json, double value) {
  if (std::isfinite(value))
    json.value(value);
  else
    json.null();
}

void write_values(JsonWriter& json, const char* name, const std::vector<double>& values) {
  json.name(name).begin_array();
  for (const double value : values) write_value(json, value);
  json.end_array();
}

template <class Integers>
void write_integers(JsonWriter& json, const char* name, const Integers& integers) {
  json.name(name).begin_array();
  for (const auto integer : integers) json.value(integer);
  json.end_array();
}

void write_bad_elements(JsonWriter& json, const std::string& kind, const std::vector<BadElement>& elements) {
  json.name(kind + "_elements").begin_array();
  for (const BadElement& element : elements) json.value(element.triangle);
  json.end_array();
  json.name(kind + "_places").begin_array();
  for (const BadElement& element : elements) {
    json.begin_array();
    write_value(json, element.centroid.x);
    write_value(json, element.centroid.y);
    json.end_array();
  }
  json.end_array();
}

void write_overlap_places(JsonWriter& json, const std::vector<OverlapPlace>& places) {
  json.name("overlap_places").begin_array();
  for (const OverlapPlace& overlap : places) {
    json.begin_object();
    json.name("triangles").begin_array();
    for (const TriangleId t : {overlap.first, overlap.second})
      if (t != none) json.value(t);
    json.end_array();
    write_values(json, "at", {overlap.place.x, overlap.place.y});
    json.end_object();
  }
  json.end_array();
}

void write_faults(JsonWriter& json, const std::vector<Fault>& faults) {
  json.name("faults").begin_array();
  for (const Fault& fault : faults) {
    json.begin_object();
    json.name("invariant").value(fault.invariant);
    json.name("place").value(fault.place);
    json.name("text").value(fault.text);
    json.end_object();
  }
  json.end_array();
}

void write_faces(JsonWriter& json, const std::vector<FaceFigures>& faces) {
  json.name("faces").begin_array();
  for (const FaceFigures& face : faces) {
    json.begin_object();
    json.name("name").value(face.name);
    json.name("triangles").value(face.triangles);
    write_value(json.name("area"), face.area);
    write_value(json.name("perimeter"), face.perimeter);
    json.end_object();
  }
  json.end_array();
}

void write_fields(JsonWriter& json, const std::vector<FieldFigures>& fields) {
  json.name("fields").begin_array();
  for (const FieldFigures& field : fields) {
    json.begin_object();
    json.name("name").value(field.name);
    write_values(json, "min", field.min);
    write_values(json, "max", field.max);
    write_values(json, "integral", field.integral);
    json.end_object();
  }
  json.end_array();
}

void write_metric(JsonWriter& json, const MetricSummary& metric) {
  json.name(metric.name).begin_object();
  write_value(json.name("min"), metric.min);
  write_value(json.name("max"), metric.max);
  write_value(json.name("mean"), metric.mean);
  json.name("count").value(metric.count);
  json.name("missing").value(metric.missing);
  if (metric.histogram.empty()) {
    json.name("histogram").null();
  } else {
    json.name("histogram").begin_object();
    write_value(json.name("low"), metric.histogram_low);
    write_value(json.name("high"), metric.histogram_high);
    write_integers(json, "counts", metric.histogram);
    json.end_object();
  }
  json.name("worst").begin_array();
  for (const WorstElement& worst : metric.worst) {
    json.begin_object();
    json.name("triangle").value(worst.triangle);
    write_value(json.name("value"), worst.value);
    write_values(json, "at", {worst.centroid.x, worst.centroid.y});
    json.end_object();
  }
  json.end_array();
  json.end_object();
}

}  // namespace

void write_report(const QualityReport& report, std::string& out) {
  JsonWriter json(out);
  json.begin_object();
  json.name("format").value("pliant-quality");
  json.name("version").value(1);
  json.name("triangles").value(report.triangles);
  json.name("vertices").value(report.vertices);
  json.name("control_points").value(report.control_points);
  json.name("degree").value(report.degree);
  write_value(json.name("time"), report.time);
  write_value(json.name("area"), report.area);
  json.name("invalid").value(report.invalid);
  json.name("degenerate").value(report.degenerate);
  write_bad_elements(json, "invalid", report.invalid_elements);
  write_bad_elements(json, "degenerate", report.degenerate_elements);
  json.name("overlaps").value(report.overlaps);
  write_overlap_places(json, report.overlap_places);
  json.name("duplicate_points").value(report.duplicate_points);
  json.name("unused_points").value(report.unused_points);
  write_faults(json, report.faults);
  json.name("tangent_jump");
  if (report.tangent_jump)
    write_value(json, *report.tangent_jump);
  else
    json.null();
  write_faces(json, report.faces);
  write_fields(json, report.fields);
  for (const MetricSummary& metric : report.metrics) write_metric(json, metric);
  json.end_object();
  out += '\n';
}

}  // namespace pliant
