// tests/formats/metrics_test.cpp: pages, schemas, pictures and reports say of the metrics what their one table says.
#include "pliant/quality/metrics.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "formats/picture/coloring.h"
#include "pliant/quality/quality_report.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

std::string text_of(const std::string& page) {
  std::ifstream in(std::string(PLIANT_FORMAT_PAGES) + "/" + page);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The cells of the table's row.
using Row = std::vector<std::string>;

/// The rows of the first table of the page whose head has these cells.
std::vector<Row> table_of(const std::string& page, const Row& head) {
  std::vector<Row> rows;
  bool is_inside = false;
  const std::string text = text_of(page);
  for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
    end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    Row cells;
    for (std::size_t from = 2, to = 0; (to = line.find(" |", from)) != std::string::npos; from = to + 3)
      cells.push_back(line.substr(from, to - from));
    if (is_inside && !line.starts_with("|")) break;
    if (is_inside && !line.starts_with("|--")) rows.push_back(cells);
    is_inside = is_inside || cells == head;
  }
  REQUIRE(is_inside);
  return rows;
}

std::string in_code(std::string_view name) { return "`" + std::string(name) + "`"; }
std::string worst_of(const Metric& metric) { return metric.worst_is_least ? "least" : "largest"; }

}  // namespace

TEST_CASE("the page of the metrics has their table, word for word, and a section for each", "[formats][metrics]") {
  std::vector<Row> rows;
  for (const Metric& metric : all_metrics())
    rows.push_back({in_code(metric.name), std::string(metric.label), std::string(unit_name(metric.unit)),
                    worst_of(metric), std::string(metric.text)});
  CHECK(table_of("metrics.md", {"metric", "label", "unit", "worst", "in a sentence"}) == rows);

  std::set<std::string> sections, names;
  const std::string page = text_of("metrics.md");
  for (std::size_t at = page.find("\n## "); at != std::string::npos; at = page.find("\n## ", at + 1)) {
    std::string heading = page.substr(at + 4, page.find('\n', at + 1) - at - 4) + ", ";
    for (std::size_t end = 0; (end = heading.find(", ")) != std::string::npos; heading.erase(0, end + 2))
      sections.insert(heading.substr(0, end));
  }
  for (const Metric& metric : all_metrics()) names.emplace(metric.name);
  names.insert({"Validity", "All metrics"});
  CHECK(sections == names);
}

TEST_CASE("the page and the schema of the report list its metrics in their order", "[formats][metrics]") {
  std::vector<std::pair<std::string, std::string>> told, known;
  for (const Row& row : table_of("report.md", {"metric", "of an element", "worst", "histogram"}))
    told.emplace_back(row.at(0), row.at(2));
  for (const Metric* metric : report_metrics()) known.emplace_back(in_code(metric->name), worst_of(*metric));
  CHECK(told == known);

  const auto schema = nlohmann::ordered_json::parse(text_of("report.schema.json"));
  const auto required = schema["required"].get<std::vector<std::string>>();
  std::vector<std::string> properties, names;
  for (const auto& [name, property] : schema["properties"].items())
    if (property == nlohmann::ordered_json{{"$ref", "#/$defs/metric"}}) properties.push_back(name);
  for (const Metric* metric : report_metrics()) {
    names.emplace_back(metric->name);
    CHECK(std::ranges::count(required, names.back()) == 1);
  }
  CHECK(properties == names);
}

TEST_CASE("the manual pages name all metrics", "[formats][metrics]") {
  for (const char* page : {"qualityreport.1", "export-svg.1", "export-gltf.1"}) {
    const std::string text = text_of(std::string("../man/") + page);
    for (const Metric* metric : report_metrics()) {
      CAPTURE(page, metric->name);
      const std::string name(metric->name);
      const bool is_named = text.find("Cm " + name + "\n") != std::string::npos ||
                            text.find("Cm " + name + " ") != std::string::npos ||
                            text.find(", " + name + " ") != std::string::npos;
      CHECK(is_named);
    }
  }
}

TEST_CASE("pictures are coloured by the numbers of the report, to the last bit", "[formats][metrics]") {
  const int degree = GENERATE(1, 2, 3, 5);
  const bool is_tangled = GENERATE(false, true);
  MeshData mesh = samples::three_disks(degree);
  if (is_tangled) mesh.points[static_cast<std::size_t>(mesh.triangles[0])] = {5, 5};
  ElementFigures elements;
  const QualityReport report = report_quality(mesh, {}, &elements);
  CHECK((report.invalid > 0) == is_tangled);
  REQUIRE(report.metrics.size() == report_metrics().size());
  REQUIRE(elements.columns.size() == all_metrics().size());
  for (std::size_t m = 0; m < elements.columns.size(); ++m) {
    const Metric& metric = all_metrics()[m];
    CAPTURE(degree, is_tangled, metric.name);
    CHECK(elements.columns[m].name == metric.name);
    CHECK(elements.columns[m].worst_is_least == metric.worst_is_least);
    CHECK(find_metric(metric.name) == &metric);
    if (find_report_metric(metric.name) == nullptr) {
      CHECK_THROWS_AS(parse_color_by(std::string(metric.name)), std::invalid_argument);
      continue;
    }
    const ElementValues values(mesh, parse_color_by(std::string(metric.name)));
    CHECK(values.title() == metric.title);
    int differences = 0;
    for (std::size_t t = 0; t < mesh.triangle_faces.size(); ++t)
      if (std::bit_cast<std::uint64_t>(values.of_element(static_cast<TriangleId>(t))) !=
          std::bit_cast<std::uint64_t>(elements.columns[m].values[t]))
        ++differences;
    CHECK(differences == 0);
  }
}

TEST_CASE("metrics grow with the lengths as their unit says", "[formats][metrics]") {
  const MeshData mesh = samples::three_disks(3);
  MeshData twice = mesh;
  for (Point& p : twice.points) p *= 2;
  for (const Metric& metric : all_metrics()) {
    CAPTURE(metric.name);
    const double factor = unit_factor(metric.unit, 2);
    const std::vector<double> small = element_values(mesh, metric), large = element_values(twice, metric);
    for (std::size_t t = 0; t < small.size(); ++t) CHECK(large[t] == Approx(factor * small[t]).epsilon(1e-12));
  }
}
