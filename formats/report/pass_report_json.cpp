// formats/report/pass_report_json.cpp: members in the order of formats/pass_report.md.
#include "formats/report/pass_report_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "formats/document/document_value.h"

namespace pliant {
namespace {

Json to_json(const QualitySummary& summary) {
  Json fields = Json::array();
  for (const ComponentSize& size : summary.fields)
    fields.push_back({{"name", size.field},
                      {"component", size.component},
                      {"largest", count_or_number(size.largest)},
                      {"l2", count_or_number(size.l2)}});
  return {{"triangles", summary.triangles},
          {"invalid", summary.invalid},
          {"degenerate", summary.degenerate},
          {"min_logical_angle", count_or_number(summary.min_logical_angle)},
          {"min_scaled_jacobian", count_or_number(summary.min_scaled_jacobian)},
          {"min_shape", count_or_number(summary.min_shape)},
          {"max_distortion", count_or_number(summary.max_distortion)},
          {"fields", std::move(fields)}};
}

Json to_json(const MissedGoals& missed) {
  return {{"invalid", missed.invalid},
          {"turned_over", missed.turned_over},
          {"too_curved", missed.too_curved},
          {"too_large", missed.too_large},
          {"too_poor", missed.too_poor}};
}

Json growth_of(const QualityChange& quality) {
  Json list = Json::array();
  for (const ComponentGrowth& growth : field_growth(quality.before, quality.after))
    list.push_back({{"name", growth.field},
                    {"component", growth.component},
                    {"largest", count_or_number(growth.largest)},
                    {"l2", count_or_number(growth.l2)}});
  return list;
}

Json refusals_of(const PassReport& report) {
  Json refusals = Json::object();
  for (const auto& [reason, times] : report.refusals) refusals[reason] = times;
  return refusals;
}

Json places_of(const PassReport& report) {
  Json places = Json::array();
  for (const auto& [reason, place] : report.refused_at)
    places.push_back({{"reason", reason}, {"x", count_or_number(place.x)}, {"y", count_or_number(place.y)}});
  return places;
}

Json seconds_of(const PassRun& run) {
  constexpr double digits = 1e6;  // the clock is not better than microseconds
  Json seconds = Json::object();
  for (const auto& [name, value] : run.seconds) seconds[name] = std::round(digits * value) / digits;
  return seconds;
}

}  // namespace

void write_pass_report(const PassRun& run, const PassReport& report, const QualityChange* quality, std::string& out) {
  Json line{{"tool", run.tool}, {"frame", run.frame}, {"time", count_or_number(run.time)}, {"values", Json::object()}};
  for (const auto& [name, value] : report.values) line["values"][name] = count_or_number(value);
  line["refusals"] = refusals_of(report);
  line["refused_at"] = places_of(report);
  line["notes"] = report.notes;
  if (quality != nullptr) {
    line["before"] = to_json(quality->before);
    line["after"] = to_json(quality->after);
    line["missed_before"] = to_json(quality->missed_before);
    line["missed_after"] = to_json(quality->missed_after);
    line["growth"] = growth_of(*quality);
  }
  line["seconds"] = seconds_of(run);
  append_json(out, line);
  out += '\n';
}

}  // namespace pliant
