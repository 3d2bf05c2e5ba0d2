// tests/formats/report_html_test.cpp: the page is one document that holds the mesh bit for bit and fetches nothing.
#include "formats/report/report_html.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "support/sample_meshes.h"

using namespace pliant;

namespace {

std::string page_of(const std::vector<MeshData>& series, const HtmlReport::Options& options = {"title", 5}) {
  std::string page;
  HtmlReport::begin(options, page);
  for (const MeshData& mesh : series) {
    ElementFigures elements;
    const QualityReport report = report_quality(mesh, {}, &elements);
    HtmlReport::frame(mesh, report, elements, "sample", page);
  }
  HtmlReport::end(page);
  return page;
}

/// The contents of the script elements with this attribute.
std::vector<nlohmann::json> scripts(const std::string& page, const std::string& attribute) {
  std::vector<nlohmann::json> found;
  const std::string open = "<script type=\"application/json\" " + attribute + ">";
  for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at + 1)) {
    const std::size_t from = at + open.size();
    found.push_back(nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from)));
  }
  return found;
}

template <class Number>
std::vector<Number> decoded(const std::string& text) {
  std::string bytes;
  unsigned bits = 0;
  int held = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/").find(c);
    REQUIRE(digit != std::string::npos);
    bits = bits << 6 | static_cast<unsigned>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 255);
  }
  REQUIRE(bytes.size() % sizeof(Number) == 0);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

int occurrences(const std::string& text, const std::string& what) {
  int count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

template <class Named>
const Named& named(const std::vector<Named>& all, const std::string& name) {
  const auto found = std::ranges::find_if(all, [&name](const Named& each) { return each.name == name; });
  REQUIRE(found != all.end());
  return *found;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

}  // namespace

TEST_CASE("the page is one document that names no other", "[formats]") {
  const std::string page = page_of({samples::disk(2), samples::three_disks(3)});
  CHECK(page.starts_with("<!doctype html>\n"));
  CHECK(page.ends_with("</html>\n"));
  for (const char* once : {"<!doctype html>", "<html ", "</html>", "<head>", "</head>", "<body>", "</body>", "<style>"})
    CHECK(occurrences(page, once) == 1);
  CHECK(occurrences(page, "<script") == occurrences(page, "</script>"));
  CHECK(occurrences(page, "<script") == 1 + 2 * 2 + 1);
  for (const char* other : {" src=", "<link", "@import", "import(", "fetch(", "XMLHttpRequest", "https://"})
    CHECK(occurrences(page, other) == 0);
  CHECK(occurrences(page, "url(") == occurrences(page, "url(#"));  // all of them refer into the page
  // The namespace of SVG looks like an address, but no browser fetches it.
  CHECK(occurrences(page, "http://") == occurrences(page, "'http://www.w3.org/2000/svg'"));
}

TEST_CASE("the page holds the mesh and its figures to the last bit", "[formats]") {
  const int degree = GENERATE(1, 2, 3, 5);
  const MeshData mesh = samples::three_disks(degree);
  ElementFigures elements;
  const QualityReport report = report_quality(mesh, {}, &elements);
  const std::string page = page_of({mesh});
  const std::vector<nlohmann::json> meshes = scripts(page, "class=\"mesh\"");
  REQUIRE(meshes.size() == 1);
  const nlohmann::json& data = meshes[0];
  CHECK(data["degree"] == degree);
  std::vector<double> points;
  for (const Point& p : mesh.points) points.insert(points.end(), {p.x, p.y});
  CHECK(same_bits(decoded<double>(data["points"]), points));
  CHECK(decoded<std::int32_t>(data["nets"]) == mesh.triangles);
  CHECK(decoded<std::int32_t>(data["triangles"]) == elements.triangles);
  CHECK(decoded<std::int32_t>(data["faces"]) == mesh.triangle_faces);
  CHECK(decoded<unsigned char>(data["validity"]) == std::vector<unsigned char>(elements.triangles.size(), 0));
  REQUIRE(data["columns"].size() == elements.columns.size());
  for (std::size_t c = 0; c < elements.columns.size(); ++c) {
    CHECK(data["columns"][c]["name"] == elements.columns[c].name);
    CHECK(data["columns"][c]["worst_is_least"] == elements.columns[c].worst_is_least);
    CHECK(same_bits(decoded<double>(data["columns"][c]["values"]), elements.columns[c].values));
  }
  const nlohmann::json summary = scripts(page, "class=\"frame\"").at(0);
  CHECK(summary["report"]["triangles"] == report.triangles);
  const MetricSummary& shape = named(report.metrics, "shape");
  CHECK(summary["report"]["shape"]["min"] == shape.min);
  CHECK(summary["ranges"]["shape"] == nlohmann::json({shape.min, shape.max}));
}

TEST_CASE("no name can leave its place in the page", "[formats]") {
  const std::string name = "</script><b>&\"'<!--<script>\u2028\x01";
  MeshData mesh = samples::disk(2);
  mesh.boundary.faces[0].name = name;
  samples::add_field(mesh, name, 1, [](const Point& p) { return std::vector<double>{p.x}; });
  const std::string page = page_of({mesh}, {name, 5});
  CHECK(occurrences(page, "<b>") == 0);
  CHECK(occurrences(page, "<!--") == 0);
  CHECK(occurrences(page, "<script") == 4);
  CHECK(occurrences(page, "</script>") == 4);
  CHECK(scripts(page, "id=\"settings\"").at(0)["title"] == name);
  CHECK(scripts(page, "class=\"mesh\"").at(0)["face_names"][0] == name);
  const nlohmann::json report = scripts(page, "class=\"frame\"").at(0)["report"];
  CHECK(report["faces"][0]["name"] == name);
  CHECK(report["fields"][0]["name"] == name);
  CHECK(page.find("<title>&lt;/script&gt;&lt;b&gt;") != std::string::npos);
}

TEST_CASE("colours span the values of elements that are not invalid", "[formats]") {
  MeshData mesh = samples::disk(2);
  for (Point& p : mesh.points)
    if (p == Point{0, 0}) p = {5, 5};
  ElementFigures elements;
  report_quality(mesh, {}, &elements);
  const std::string page = page_of({mesh});
  const nlohmann::json data = scripts(page, "class=\"mesh\"").at(0);
  const std::vector<unsigned char> validity = decoded<unsigned char>(data["validity"]);
  const ElementColumn& shape = named(elements.columns, "shape");
  double low = HUGE_VAL;
  for (std::size_t k = 0; k < validity.size(); ++k) {
    CHECK(validity[k] == static_cast<unsigned char>(elements.validity[k]));
    if (elements.validity[k] != Validity::invalid) low = std::min(low, shape.values[k]);
  }
  CHECK(std::ranges::count(validity, static_cast<unsigned char>(Validity::invalid)) > 0);
  CHECK(scripts(page, "class=\"frame\"").at(0)["ranges"]["shape"][0] == low);
}

TEST_CASE("a page without elements is a page", "[formats]") {
  MeshData mesh = samples::disk(2);
  mesh.triangles.clear();
  mesh.triangle_faces.clear();
  mesh.constrained_edges.clear();
  const nlohmann::json data = scripts(page_of({mesh}), "class=\"mesh\"").at(0);
  CHECK(data["nets"] == "");
  CHECK(scripts(page_of({mesh}), "class=\"frame\"").at(0)["ranges"]["shape"].is_null());
}
