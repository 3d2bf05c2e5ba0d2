// tests/formats/picture/svg_test.cpp: pictures are well-formed, and draw each edge once, as the curve it is.
#include "formats/picture/svg.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <random>
#include <regex>

#include "formats/picture/mesh_edges.h"
#include "formats/picture/svg/path.h"
#include "pliant/geometry/control_net.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/quality/metrics.h"
#include "support/sample_meshes.h"
#include "support/svg_texts.h"

namespace pliant {
namespace {

using samples::numbers, samples::svg_of;

/// Why the text is not well-formed XML (of the kind we write: no comments, declarations or CDATA); empty if it is.
class XmlCheck {
 public:
  explicit XmlCheck(const std::string& text) : text_(text) {}
  std::string fault() {
    while (fault_.empty() && at_ < text_.size()) {
      if (text_[at_] == '<')
        tag();
      else
        character(open_.empty() ? "\n" : "");
    }
    if (fault_.empty() && (!open_.empty() || roots_ != 1)) fault_ = "not one whole element";
    return fault_;
  }

 private:
  void fail(const std::string& why) {
    if (fault_.empty()) fault_ = why + " before " + text_.substr(std::min(at_, text_.size()), 60);
  }
  bool take(char c) { return at_ < text_.size() && text_[at_] == c && (++at_, true); }
  std::string name() {
    const std::size_t from = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '-' || text_[at_] == ':'))
      ++at_;
    if (at_ == from) fail("no name");
    return text_.substr(from, at_ - from);
  }
  /// One character of text or of an attribute; `only`: if not empty, what may stand here.
  void character(const std::string& only) {
    const char c = text_[at_];
    if (!only.empty() && only.find(c) == std::string::npos) fail("text outside of the root");
    if (c == '<' || c == '>' || (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')) fail("raw character");
    if (c == '&') {
      const std::string entity = text_.substr(at_, text_.find(';', at_) - at_);
      if (entity != "&amp" && entity != "&lt" && entity != "&gt" && entity != "&quot") fail("bare ampersand");
    }
    ++at_;
  }
  void tag() {
    take('<');
    if (take('/')) {
      if (open_.empty() || open_.back() != name()) return fail("closes another element");
      open_.pop_back();
      if (!take('>')) fail("no end of a tag");
      return;
    }
    if (open_.empty()) ++roots_;
    open_.push_back(name());
    std::vector<std::string> attributes;
    while (take(' ')) {
      attributes.push_back(name());
      if (std::count(attributes.begin(), attributes.end(), attributes.back()) > 1) fail("attribute given twice");
      if (!take('=') || !take('"')) return fail("no value of an attribute");
      while (fault_.empty() && at_ < text_.size() && text_[at_] != '"') character("");
      if (!take('"')) return fail("no end of a value");
    }
    if (take('/')) open_.pop_back();
    if (!take('>')) fail("no end of a tag");
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int roots_ = 0;
  std::vector<std::string> open_;
  std::string fault_;
};
std::string xml_fault(const std::string& text) { return XmlCheck(text).fault(); }

std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t first = text.find(from);
  REQUIRE(first != std::string::npos);
  return text.substr(first, text.find(to, first) - first);
}

MeshData colorful_disks(int degree) {
  MeshData mesh = samples::three_disks(degree);
  samples::add_field(mesh, "wave", 1, [](const Point& p) { return std::vector<double>{std::sin(3 * p.x) * p.y}; });
  samples::add_field(mesh, "x", 1, [](const Point& p) { return std::vector<double>{p.x}; });
  samples::add_field(mesh, "place", 2, [](const Point& p) { return std::vector<double>{p.x, p.y}; });
  return mesh;
}

}  // namespace

TEST_CASE("the hand-made meshes satisfy the structural invariants and are valid", "[formats]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  CAPTURE(degree);
  const MeshData mesh = samples::three_disks(degree);
  CHECK(check_structure(mesh).empty());
  CHECK(find_invalid(mesh).empty());
}

TEST_CASE("a picture is well-formed XML in every degree and colouring", "[formats][svg]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const MeshData mesh = colorful_disks(degree);
  SvgOptions options;
  options.control_net = degree % 2 == 1;
  options.circles = {{{1.5, 0.5}, 0.25}};
  std::vector<std::string> colors{"none", "face", "field:wave", "field:place", "field:place.1"};
  for (const Metric* metric : report_metrics()) colors.emplace_back(metric->name);
  for (const std::string& color : colors) {
    CAPTURE(degree, color);
    const std::string text = svg_of(mesh, color, options);
    CHECK(xml_fault(text) == "");
    CHECK(text.find("nan") == std::string::npos);
    CHECK(text.find("inf\"") == std::string::npos);
  }
}

TEST_CASE("each edge is drawn once, as the curve it is", "[formats][svg]") {
  const int degree = GENERATE(1, 2, 3);
  CAPTURE(degree);
  const char letter = " LQC"[degree];
  const MeshData mesh = samples::three_disks(degree);
  const MeshEdges edges = find_edges(mesh);
  const std::string text = svg_of(mesh, "none");
  const std::string inner = between(between(text, "class=\"edges\"", "/>"), " d=\"", "\"/>");
  const auto straight = degree > 1 ? std::count(inner.begin(), inner.end(), 'L') : 0;  // the disks' inner edges
  CHECK((degree == 1 || straight > 0));
  const auto inner_count = std::count(inner.begin(), inner.end(), letter) + straight;
  CHECK(inner_count == static_cast<long>(edges.edges.size() - mesh.constrained_edges.size()));
  CHECK(std::count(inner.begin(), inner.end(), 'M') == inner_count);
  const std::string curves = between(text, "class=\"curves\"", "</g>");
  long on_curves = 0;
  for (std::size_t at = curves.find("d=\"M"); at != std::string::npos; at = curves.find("d=\"M", at + 1)) {
    const std::string data = curves.substr(at + 3, curves.find('"', at + 3) - at - 3);
    on_curves += std::count(data.begin(), data.end(), letter);
    CHECK(data.back() == 'Z');
  }
  CHECK(on_curves == static_cast<long>(mesh.constrained_edges.size()));
}

TEST_CASE("an edge's control point stands in the path, with y turned over", "[formats][svg]") {
  MeshData mesh = samples::disk(2);
  // Control point 3 of the first element is that of its edge from corner 1 to corner 2.
  const auto bent = static_cast<std::size_t>(mesh.triangles[3]);
  mesh.points[bent] = {0.28125, -0.015625};
  const std::string edges = between(svg_of(mesh, "none"), "class=\"edges\"", "/>");
  CHECK(edges.find("Q0.28125 0.015625 ") != std::string::npos);
}

TEST_CASE("curves of degree four and more are drawn within the tolerance", "[formats][svg][property]") {
  const int seed = GENERATE(range(0, 20));
  CAPTURE(seed);
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const int degree = 4 + seed % 4;
  std::vector<Point> polygon;
  std::vector<double> rows;
  for (int k = 0; k <= degree; ++k) {
    polygon.push_back({coordinate(random), coordinate(random)});
    rows.insert(rows.end(), {polygon.back().x, polygon.back().y});
  }
  constexpr double tolerance = 1e-3;
  std::string text;
  SvgPath(text, 1, tolerance).curve_to(polygon);
  const std::vector<double> data = numbers(text);
  REQUIRE(data.size() % 6 == 0);
  CHECK(data[data.size() - 2] == Approx(polygon.back().x).margin(1e-6));
  Point from = polygon.front();
  for (std::size_t i = 0; i < data.size(); i += 6) {
    const std::vector<double> cubic{from.x,      from.y,       data[i],     -data[i + 1],
                                    data[i + 2], -data[i + 3], data[i + 4], -data[i + 5]};
    from = {data[i + 4], -data[i + 5]};
    for (const double s : {0.25, 0.5, 0.75}) {
      std::array<double, 2> drawn{}, there{};
      evaluate_polygon(3, 2, cubic, s, drawn);
      double nearest = HUGE_VAL;
      for (int k = 0; k <= 4096; ++k) {
        evaluate_polygon(degree, 2, rows, k / 4096.0, there);
        nearest = std::min(nearest, std::hypot(there[0] - drawn[0], there[1] - drawn[1]));
      }
      CHECK(nearest < 2 * tolerance);
    }
  }
}

TEST_CASE("numbers are rounded to a ten-millionth of the mesh's size", "[formats][svg]") {
  const double size = GENERATE(1e-5, 0.1, 1.0, 37.0, 9e5);
  CAPTURE(size);
  for (const double part : {0.123456789123, -0.987654321987, 1.0 / 3, 0.5, 0.0, -1e-12}) {
    std::string text;
    SvgPath(text, size, 0).number(part * size);
    CHECK(std::abs(std::stod(text) - part * size) <= 0.5e-7 * size);
    CHECK(text != "-0");
  }
}

TEST_CASE("an edge that is straight within the resolution is a line, and others are not", "[formats][svg]") {
  const double bend = GENERATE(0.0, 1e-9, 1e-6, 1e-3);
  CAPTURE(bend);
  std::string fine, coarse;
  const std::vector<Point> polygon{{0, 0}, {0.5, bend}, {1, 0}};
  SvgPath(fine, 1, 0).curve_to(polygon);
  SvgPath(coarse, 1, 0, 1e-4).curve_to(polygon);
  CHECK(fine == (bend < 1e-7 ? "L1 0" : bend < 1e-5 ? "Q0.5 -0.000001 1 0" : "Q0.5 -0.001 1 0"));
  CHECK(coarse == (bend < 1e-4 ? "L1 0" : "Q0.5 -0.001 1 0"));
  // Parameters are not even along this straight curve. A line would have other colours along it, so it stays a curve.
  std::string uneven;
  SvgPath(uneven, 1, 0).curve_to({{0, 0}, {0.25, 0}, {1, 0}});
  CHECK(uneven == "Q0.25 0 1 0");
}

TEST_CASE("a linear field is shaded exactly: every gradient reaches from its least to its greatest value",
          "[formats][svg]") {
  const int degree = GENERATE(1, 2, 3);
  const MeshData mesh = colorful_disks(degree);
  SvgOptions options;
  options.range = {-2, 5};
  const std::string text = svg_of(mesh, "field:x", options);
  const std::regex gradient(
      R"re(<linearGradient id="g\d+" xlink:href="#map" x1="([^"]+)" y1="([^"]+)" x2="([^"]+)" y2="([^"]+)")re");
  long found = 0;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), gradient); it != std::sregex_iterator();
       ++it, ++found) {
    CHECK(std::stod((*it)[1]) == Approx(-2).margin(1e-5));
    CHECK(std::stod((*it)[3]) == Approx(5).margin(1e-5));
    CHECK(std::stod((*it)[2]) == Approx(std::stod((*it)[4])).margin(1e-5));
  }
  CHECK(found == static_cast<long>(mesh.triangle_faces.size()));
}

TEST_CASE("the worst and the best element have the ends of the colour map", "[formats][svg]") {
  const MeshData mesh = samples::disk(2);
  const std::string elements = between(svg_of(mesh, "shape"), "class=\"elements\"", "</g>");
  CHECK(elements.find(hex(colormaps()[0].stops.front())) != std::string::npos);
  CHECK(elements.find(hex(colormaps()[0].stops.back())) != std::string::npos);
}

TEST_CASE("elements that are not valid are counted and marked", "[formats][svg]") {
  MeshData mesh = samples::disk(2);
  CHECK(svg_of(mesh, "shape").find("class=\"invalid\"") == std::string::npos);
  mesh.points[static_cast<std::size_t>(mesh.triangles[3])] += Point{0.4, 0.9};
  const std::size_t invalid = find_invalid(mesh).invalid.size();
  REQUIRE(invalid > 0);
  const std::string text = svg_of(mesh, "shape");
  CHECK(text.find(std::to_string(invalid) + " invalid, 0 degenerate</desc>") != std::string::npos);
  CHECK(text.find("class=\"invalid\" fill=\"" + hex(invalid_color)) != std::string::npos);
  CHECK(xml_fault(text) == "");
}

TEST_CASE("a given box is shown as it is, so that stills share a frame", "[formats][svg]") {
  SvgOptions options;
  options.box = Box{{-1, -2}, {3, 0.5}};
  options.width = 800;
  options.legend = false;
  const std::string text = svg_of(samples::disk(3), "face", options);
  CHECK(text.find("viewBox=\"-1 -0.5 4 2.5\"") != std::string::npos);
  CHECK(text.find("viewBox=\"0 0 800 500\"") != std::string::npos);
}

TEST_CASE("names of faces and curves cannot break the picture", "[formats][svg]") {
  MeshData mesh = samples::disk(2);
  mesh.boundary.faces[0].name = "<a href=\"x\">&\x01</a>";
  mesh.boundary.curves[0].name = "]]>\"&amp;";
  CHECK(xml_fault(svg_of(mesh, "face")) == "");
}

TEST_CASE("what a mesh does not have cannot colour it, and the message says what it has", "[formats][svg]") {
  const MeshData mesh = colorful_disks(2);
  CHECK_THROWS_WITH(svg_of(mesh, "field:heat"), Catch::Contains("wave, x, place"));
  CHECK_THROWS_WITH(svg_of(mesh, "field:place.2"), Catch::Contains("0 to 1"));
  CHECK_THROWS_WITH(svg_of(mesh, "beauty"), Catch::Contains("scaled_jacobian"));
}

TEST_CASE("a field whose name holds a dot is found by its whole name", "[formats][svg]") {
  MeshData mesh = samples::disk(2);
  samples::add_field(mesh, "u.1", 1, [](const Point& p) { return std::vector<double>{p.x}; });
  samples::add_field(mesh, "u", 2, [](const Point& p) { return std::vector<double>{0, 7 + p.y}; });
  CHECK(ElementValues(mesh, parse_color_by("field:u.1")).range().low < 0);
  CHECK(ElementValues(mesh, parse_color_by("field:u.0")).range().high == 0);
}

TEST_CASE("ticks are round, within the range, and about as many as asked for", "[formats][svg][property]") {
  const int seed = GENERATE(range(0, 50));
  CAPTURE(seed);
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> part(-1, 1), power(-8, 8);
  ValueRange range;
  for (int k = 0; k < 2; ++k) range.extend(part(random) * std::pow(10, power(random)));
  const std::vector<double> marks = ticks(range, 5);
  CHECK(marks.size() >= 2);
  CHECK(marks.size() <= 7);
  for (const double mark : marks) {
    CHECK(mark >= range.low - 1e-9 * (range.high - range.low));
    CHECK(mark <= range.high + 1e-9 * (range.high - range.low));
  }
}

TEST_CASE("a range that is hardly wider than rounding has few ticks", "[formats][svg]") {
  const double low = GENERATE(0.12, 1.99, 60.0, -120.0);
  const int steps = GENERATE(range(1, 8));
  const int count = GENERATE(range(2, 7));
  CAPTURE(low, steps, count);
  ValueRange range{low, low};
  for (int k = 0; k < steps; ++k) range.high = std::nextafter(range.high, HUGE_VAL);
  CHECK(ticks(range, count).size() <= 9);
}

TEST_CASE("a mesh without elements is an empty picture", "[formats][svg]") {
  MeshData mesh;
  mesh.degree = 2;
  std::string picture;
  const SvgOptions options;
  write_svg(mesh, options, picture);
  CHECK(picture.find("nan") == std::string::npos);
  CHECK(picture.find("inf") == std::string::npos);
}

}  // namespace pliant
