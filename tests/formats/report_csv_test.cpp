// tests/formats/report_csv_test.cpp: the table says of each element what the library measured.
#include "formats/report/report_csv.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "pliant/quality/quality_report.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

using Table = std::vector<std::vector<std::string>>;

/// The grammar of RFC 4180, with line feeds.
Table parsed(const std::string& text) {
  Table table;
  std::vector<std::string> row;
  std::string cell;
  bool is_quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (is_quoted && c == '"' && k + 1 < text.size() && text[k + 1] == '"') {
      cell += text[++k];
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (!is_quoted && (c == ',' || c == '\n')) {
      row.push_back(cell);
      cell.clear();
      if (c == '\n') {
        table.push_back(row);
        row.clear();
      }
    } else {
      cell += c;
    }
  }
  REQUIRE(cell.empty());
  REQUIRE(row.empty());
  return table;
}

Table table_of(const MeshData& mesh, const QualityOptions& options, ElementFigures& elements) {
  report_quality(mesh, options, &elements);
  std::string text;
  write_csv_header(elements, text);
  write_csv_elements(mesh, elements, 3, text);
  return parsed(text);
}

}  // namespace

TEST_CASE("the table has a line an element, with every figure to the last bit", "[formats]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const MeshData mesh = samples::three_disks(degree);
  ElementFigures elements;
  const Table table = table_of(mesh, {}, elements);
  REQUIRE(table.size() == mesh.triangle_faces.size() + 1);
  const std::vector<std::string> first{"frame", "triangle", "face", "validity", "x", "y"};
  CHECK(std::vector<std::string>(table[0].begin(), table[0].begin() + 6) == first);
  REQUIRE(table[0].size() == 6 + elements.columns.size());
  for (std::size_t k = 0; k < elements.triangles.size(); ++k) {
    const std::vector<std::string>& row = table[k + 1];
    REQUIRE(row.size() == table[0].size());
    CHECK(row[0] == "3");
    CHECK(row[1] == std::to_string(elements.triangles[k]));
    CHECK(row[2] == mesh.boundary.faces[static_cast<std::size_t>(mesh.triangle_faces[k])].name);
    CHECK(row[3] == "valid");
    for (std::size_t c = 0; c < elements.columns.size(); ++c) {
      CHECK(table[0][6 + c] == elements.columns[c].name);
      CHECK(std::strtod(row[6 + c].c_str(), nullptr) == elements.columns[c].values[k]);
    }
  }
}

TEST_CASE("a worst element of the report lies in the table where the report says", "[formats]") {
  const MeshData mesh = samples::three_disks(3);
  ElementFigures elements;
  const Table table = table_of(mesh, {}, elements);
  for (const MetricSummary& metric : report_quality(mesh).metrics) {
    for (const WorstElement& worst : metric.worst) {
      const std::vector<std::string>& row = table[static_cast<std::size_t>(worst.triangle) + 1];
      CHECK(std::strtod(row[4].c_str(), nullptr) == Approx(worst.centroid.x).margin(1e-14));
      CHECK(std::strtod(row[5].c_str(), nullptr) == Approx(worst.centroid.y).margin(1e-14));
    }
  }
}

TEST_CASE("names of faces are quoted, and values that do not exist are empty", "[formats]") {
  MeshData mesh = samples::disk(2);
  const std::string name = "a \"b\", c\nd";
  mesh.boundary.faces[0].name = name;
  for (Point& p : mesh.points) p.y = 0;  // no area: no distortion
  ElementFigures elements;
  const Table table = table_of(mesh, {}, elements);
  REQUIRE(elements.columns[6].name == "distortion");
  for (std::size_t k = 1; k < table.size(); ++k) {
    CHECK(table[k][2] == name);
    CHECK(table[k][3] == "degenerate");
    CHECK(table[k][12].empty());
  }
}

TEST_CASE("the table has the chosen faces only", "[formats]") {
  const MeshData mesh = samples::three_disks(2);
  const std::string name = mesh.boundary.faces[1].name;
  ElementFigures elements;
  const Table table = table_of(mesh, {5, 20, {name}}, elements);
  REQUIRE(table.size() > 1);
  CHECK(table.size() < mesh.triangle_faces.size());
  for (std::size_t k = 1; k < table.size(); ++k) CHECK(table[k][2] == name);
}
