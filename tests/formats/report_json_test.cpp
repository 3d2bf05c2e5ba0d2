// tests/formats/report_json_test.cpp: the report's members are stable and its numbers those of the library.
#include "formats/report/report_json.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "formats/report/report_text.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

nlohmann::ordered_json written(const QualityReport& report) {
  std::string text;
  write_report(report, {}, text);
  REQUIRE(std::ranges::count(text, '\n') == 1);
  REQUIRE(text.back() == '\n');
  return nlohmann::ordered_json::parse(text);
}

/// A mesh with fields, one of which has a name that needs care.
MeshData sample() {
  MeshData data = samples::three_disks(2);
  samples::add_field(data, "a \"name\"\n\u00e9", 1, [](const Point& p) { return std::vector<double>{p.x / 3}; });
  samples::add_field(data, "velocity", 2, [](const Point& p) { return std::vector<double>{-p.y, p.x}; });
  return data;
}

}  // namespace

TEST_CASE("the members of the report stand in the documented order", "[formats]") {
  const nlohmann::ordered_json json = written(report_quality(sample()));
  std::vector<std::string> names;
  for (const auto& [name, value] : json.items()) names.push_back(name);
  CHECK(names == std::vector<std::string>{"format",
                                          "version",
                                          "triangles",
                                          "vertices",
                                          "control_points",
                                          "degree",
                                          "time",
                                          "area",
                                          "invalid",
                                          "degenerate",
                                          "invalid_elements",
                                          "invalid_places",
                                          "degenerate_elements",
                                          "degenerate_places",
                                          "overlaps",
                                          "overlap_places",
                                          "duplicate_points",
                                          "unused_points",
                                          "faults",
                                          "tangent_jump",
                                          "faces",
                                          "fields",
                                          "jacobian",
                                          "jacobian_max",
                                          "scaled_jacobian",
                                          "shape",
                                          "logical_tau",
                                          "control_tau",
                                          "distortion",
                                          "logical_angle",
                                          "turning_angle",
                                          "edge_length",
                                          "element_area"});
  names.clear();
  for (const auto& [name, value] : json["shape"].items()) names.push_back(name);
  CHECK(names == std::vector<std::string>{"min", "max", "mean", "count", "missing", "histogram", "worst"});
}

TEST_CASE("the numbers of the report read back to the same doubles", "[formats]") {
  const QualityReport report = report_quality(sample());
  const nlohmann::ordered_json json = written(report);
  CHECK(json["area"].get<double>() == report.area);
  CHECK(json["tangent_jump"].get<double>() == report.tangent_jump.value());
  CHECK(json["fields"][0]["name"] == "a \"name\"\n\u00e9");
  for (std::size_t c = 0; c < 2; ++c)
    CHECK(json["fields"][1]["integral"][c].get<double>() == report.fields[1].integral[c]);
  for (const MetricSummary& metric : report.metrics) {
    const auto& object = json[metric.name];
    CHECK(object["min"].get<double>() == metric.min);
    CHECK(object["max"].get<double>() == metric.max);
    CHECK(object["mean"].get<double>() == metric.mean);
    CHECK(object["histogram"]["counts"].get<std::vector<std::int64_t>>() == metric.histogram);
    REQUIRE(object["worst"].size() == metric.worst.size());
    for (std::size_t k = 0; k < metric.worst.size(); ++k) {
      CHECK(object["worst"][k]["triangle"].get<TriangleId>() == metric.worst[k].triangle);
      CHECK(object["worst"][k]["value"].get<double>() == metric.worst[k].value);
      CHECK(object["worst"][k]["at"][1].get<double>() == metric.worst[k].centroid.y);
    }
  }
}

TEST_CASE("what does not exist is null", "[formats]") {
  const nlohmann::ordered_json empty = written(report_quality(MeshData{}, {5, 0, {}, 1e-3}));
  CHECK(empty["tangent_jump"].is_null());
  CHECK(empty["shape"]["min"].is_null());
  CHECK(empty["shape"]["histogram"].is_null());
  CHECK(empty["faces"].empty());
  QualityReport overflown;
  overflown.area = std::numeric_limits<double>::infinity();
  overflown.tangent_jump = std::numeric_limits<double>::quiet_NaN();
  CHECK(written(overflown)["area"].is_null());
  CHECK(written(overflown)["tangent_jump"].is_null());
}

TEST_CASE("faults are written with place and text", "[formats]") {
  MeshData data = samples::disk(2);
  data.constrained_edges.pop_back();
  const QualityReport report = report_quality(data);
  REQUIRE_FALSE(report.faults.empty());
  const nlohmann::ordered_json json = written(report);
  REQUIRE(json["faults"].size() == report.faults.size());
  CHECK(json["faults"][0]["invariant"] == report.faults[0].invariant);
  CHECK(json["faults"][0]["place"] == report.faults[0].place);
  CHECK(json["faults"][0]["text"] == report.faults[0].text);
}

TEST_CASE("the text fits 80 columns", "[formats]") {
  MeshData data = sample();
  data.boundary.faces[0].name = "a face whose name is much longer than any table would like to have it: \u00e9\u00e9";
  data.points[7].x += 1e12;
  data.constrained_edges.pop_back();
  const int bins = GENERATE(0, 1, 20, 38, 39, 1000);
  const int worst = GENERATE(0, 5, 200);
  CAPTURE(bins, worst);
  std::string text;
  write_report_text(report_quality(data, {worst, bins, {}}), {}, "file.json: frame 0", text);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    CAPTURE(line);
    CHECK(std::ranges::count_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }) <= 80);
  }
  CHECK(text.find("shape") != std::string::npos);
}

TEST_CASE("the text prints a time with the digits of a sum of round steps", "[formats]") {
  QualityReport report;
  for (const auto& [time, expected] :
       {std::pair(1000000.5, " 1000000.5 "), std::pair(4.95, " 4.95 "), std::pair(1.0 / 3, " 0.33333 ")}) {
    report.time = time;
    std::string text;
    write_report_text(report, {}, "one.json: frame 0", text);
    CHECK_THAT(text, Catch::Contains(expected));
  }
}
