// formats/report/report_json.cpp: members in the order of formats/report.md.
#include "formats/report/report_json.h"

#include <nlohmann/json.hpp>
#include <span>

#include "formats/document/document_value.h"
#include "formats/document/write_json.h"

namespace pliant {
namespace {

Json list_of(std::span<const double> values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(finite_or_null(value));
  return list;
}

Json list_of(const Point& place) { return Json::array({finite_or_null(place.x), finite_or_null(place.y)}); }

void add_bad_elements(Json& report, const std::string& kind, const std::vector<BadElement>& bad) {
  Json elements = Json::array(), places = Json::array();
  for (const BadElement& element : bad) {
    elements.push_back(element.triangle);
    places.push_back(list_of(element.centroid));
  }
  report[kind + "_elements"] = std::move(elements);
  report[kind + "_places"] = std::move(places);
}

Json to_json(const OverlapPlace& overlap) {
  Json triangles = Json::array();
  for (const TriangleId t : {overlap.first, overlap.second})
    if (t != none) triangles.push_back(t);
  return {{"triangles", std::move(triangles)}, {"at", list_of(overlap.place)}};
}

Json to_json(const Fault& fault) {
  return {{"invariant", fault.invariant}, {"place", fault.place}, {"text", fault.text}};
}

Json to_json(const FaceFigures& face) {
  return {{"name", face.name},
          {"triangles", face.triangles},
          {"area", finite_or_null(face.area)},
          {"perimeter", finite_or_null(face.perimeter)}};
}

Json to_json(const FieldFigures& field) {
  return {{"name", field.name},
          {"min", list_of(field.min)},
          {"max", list_of(field.max)},
          {"integral", list_of(field.integral)}};
}

Json to_json(const HistoryEntry& entry) {
  return {{"tool", entry.tool}, {"version", entry.version}, {"options", entry.options}};
}

template <class Figures>
Json list_of(const std::vector<Figures>& all) {
  Json list = Json::array();
  for (const Figures& one : all) list.push_back(to_json(one));
  return list;
}

Json to_json(const MetricSummary& metric) {
  Json histogram;  // null without bins
  if (!metric.histogram.empty())
    histogram = {{"low", finite_or_null(metric.histogram_low)},
                 {"high", finite_or_null(metric.histogram_high)},
                 {"counts", metric.histogram}};
  Json worst = Json::array();
  for (const WorstElement& element : metric.worst)
    worst.push_back(
        {{"triangle", element.triangle}, {"value", finite_or_null(element.value)}, {"at", list_of(element.centroid)}});
  return {{"min", finite_or_null(metric.min)},
          {"max", finite_or_null(metric.max)},
          {"mean", finite_or_null(metric.mean)},
          {"count", metric.count},
          {"missing", metric.missing},
          {"histogram", std::move(histogram)},
          {"worst", std::move(worst)}};
}

/// All but the metrics.
Json mesh_figures(const QualityReport& report) {
  Json figures{{"format", "pliant-quality"},
               {"version", 1},
               {"triangles", report.triangles},
               {"vertices", report.vertices},
               {"control_points", report.control_points},
               {"degree", report.degree},
               {"time", finite_or_null(report.time)},
               {"area", finite_or_null(report.area)},
               {"invalid", report.invalid},
               {"degenerate", report.degenerate}};
  add_bad_elements(figures, "invalid", report.invalid_elements);
  add_bad_elements(figures, "degenerate", report.degenerate_elements);
  figures["overlaps"] = report.overlaps;
  figures["overlap_places"] = list_of(report.overlap_places);
  figures["duplicate_points"] = report.duplicate_points;
  figures["unused_points"] = report.unused_points;
  figures["faults"] = list_of(report.faults);
  figures["tangent_jump"] = report.tangent_jump ? finite_or_null(*report.tangent_jump) : Json();
  figures["faces"] = list_of(report.faces);
  figures["fields"] = list_of(report.fields);
  return figures;
}

}  // namespace

void write_report(const QualityReport& report, const std::vector<HistoryEntry>& history, std::string& out) {
  JsonWriter json(out);
  json.begin_object();
  write_members(json, mesh_figures(report));
  if (!history.empty()) write_json(json.name("history"), list_of(history));
  // One metric at a time: with --worst its list may be as long as the mesh.
  for (const MetricSummary& metric : report.metrics) write_json(json.name(metric.name), to_json(metric));
  json.end_object();
  out += '\n';
}

}  // namespace pliant
