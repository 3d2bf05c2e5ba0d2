// tests/formats/picture/svg_placement_test.cpp: meshes far from the origin are drawn about an origin of their own.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>
#include <utility>

#include "formats/picture/mesh_edges.h"
#include "formats/picture/svg.h"
#include "formats/picture/svg/placement.h"
#include "pliant/geometry/control_net.h"
#include "support/sample_meshes.h"
#include "support/svg_texts.h"

namespace pliant {
namespace {

const SvgOptions plain;

/// A disk with two fields, whose coordinates lose no digit by an offset that is a whole number below 2^32.
MeshData round_numbers(double size) {
  MeshData mesh = samples::disk(3, 9, {0.25, 0.5}, 1);
  for (Point& p : mesh.points) p = size * (0x1p-20 * Point{std::round(0x1p20 * p.x), std::round(0x1p20 * p.y)});
  samples::add_field(mesh, "x", 1, [](const Point& p) { return std::vector<double>{p.x * p.y}; });
  samples::add_field(mesh, "u", 2, [](const Point& p) { return std::vector<double>{-p.y, p.x}; });
  return mesh;
}

void move_by(MeshData& mesh, const Vector& offset) {
  for (Point& p : mesh.points) p += offset;
}

/// The part of a picture that is in the coordinates of the mesh, without the attributes that place it.
std::string drawing_of(const MeshData& mesh, SvgOptions options) {
  options.color = parse_color_by("field:x");
  options.isolines = {{"x", 5, {}}};
  std::string text;
  write_svg(mesh, options, text);
  const std::size_t from = text.find(" viewBox", text.find("<svg", 1)), to = text.find("</svg>");
  text = text.substr(from, to - from);
  return std::regex_replace(text, std::regex(" data-origin=\"[^\"]*\""), "");
}

std::string origin_of(const MeshData& mesh, const SvgOptions& options) {
  std::string text;
  write_svg(mesh, options, text);
  std::smatch match;
  return std::regex_search(text, match, std::regex(" data-origin=\"([^\"]*)\"")) ? match[1].str() : "";
}

}  // namespace

TEST_CASE("a mesh far from the origin is drawn as the same mesh near it", "[formats][svg]") {
  const MeshData near = round_numbers(1);
  MeshData far = near;
  SvgOptions options, far_options;
  options.circles = {{{0.5, 0.25}, 0.125}};
  SECTION("the whole mesh") {}
  SECTION("a part of it") { options.box = Box{{0, 0.25}, {0.5, 0.5}}; }
  far_options = options;
  const Vector offset{3e6, -1e9};
  move_by(far, offset);
  far_options.circles[0].center += offset;
  if (options.box) far_options.box = Box{options.box->low + offset, options.box->high + offset};
  CHECK(drawing_of(far, far_options) == drawing_of(near, options));
  CHECK(origin_of(near, options).empty());
  CHECK(origin_of(far, far_options) == "3e+06 -1e+09");
}

TEST_CASE("an origin is given in the unit of the document", "[formats][svg]") {
  MeshData mesh = round_numbers(0x1p70);
  move_by(mesh, {0x1p100, 0});
  const PlacedDocument placed(mesh, plain);
  CHECK(placed.placement().unit > 0x1p60);
  CHECK(placed.placement().origin.y == 0);
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    CHECK(placed.placement().in_document(placed.mesh().points[p]) == mesh.points[p]);
    CHECK(length(placed.mesh().points[p]) < 4000);
  }
}

TEST_CASE("what is shown is drawn neither small nor large", "[formats][svg]") {
  const double size = GENERATE(1e-150, 1e-9, 1e-3, 0.2, 1.0, 1e3, 1e5, 1e7, 1e30, 1e150);
  CAPTURE(size);
  const MeshData mesh = round_numbers(size);
  SvgOptions options;
  if (GENERATE(false, true)) options.box = Box{{0.5 * size, 0.5 * size}, {0.501 * size, 0.501 * size}};
  const PlacedDocument placed(mesh, options);
  const double side = placed.box().high.x - placed.box().low.x;
  CHECK(side >= 0.12);
  CHECK(side <= 1.2e6);
  CHECK(std::exp2(std::ilogb(placed.placement().unit)) == placed.placement().unit);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    CHECK(distance(placed.placement().in_document(placed.mesh().points[p]), mesh.points[p]) <= 1e-15 * size);
}

TEST_CASE("only what is much farther away than it is wide gets an origin", "[formats][svg]") {
  MeshData mesh = round_numbers(1);
  move_by(mesh, {500, 0});
  CHECK(origin_of(mesh, plain).empty());
  SvgOptions options;
  options.box = Box{{500, 0.25}, {500.125, 0.375}};  // what is shown counts
  CHECK(origin_of(mesh, options) == "500 0");
  // A tiny mesh beside 1, whose coordinates differ in their last digits.
  MeshData tiny = round_numbers(0x1p-29);
  move_by(tiny, {1, 1});
  const PlacedDocument placed(tiny, plain);
  CHECK(placed.placement().origin == Point{1, 1});
  for (const Point& p : placed.mesh().points) CHECK(length(p) < 4000);
}

TEST_CASE("a mesh of one point is drawn wherever it is", "[formats][svg]") {
  MeshData mesh = round_numbers(1);
  for (Point& p : mesh.points) p = {1e100, 0.25};
  std::string text;
  write_svg(mesh, plain, text);
  CHECK(text.find("nan") == std::string::npos);
  CHECK(text.find("inf") == std::string::npos);
  CHECK(text.find(" viewBox=\"-0.53 -0.53 1.06 1.06\"") != std::string::npos);
}

TEST_CASE("a box smaller than what rounding moves points by is drawn, too", "[formats][svg]") {
  MeshData mesh = samples::disk(GENERATE(1, 2, 5), 7, {0, 0}, 1);
  samples::add_field(mesh, "x", 1, [](const Point& p) { return std::vector<double>{p.x}; });
  const double half = GENERATE(1e-15, 1e-16, 1e-17, 1e-20, 1e-100, 1e-300, 5e-324);
  CAPTURE(mesh.degree, half);
  SvgOptions options;
  options.box = Box{{-half, -half}, {half, half}};
  options.isolines = {{"x", 5, {}}};
  for (const char* color : {"field:x", "shape", "face"}) {
    const std::string svg = samples::svg_of(mesh, color, options);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find(" d=\"M") != std::string::npos);
    CHECK(svg.size() < 100'000);
  }
}

TEST_CASE("a picture from very near holds nothing that is far larger than it", "[formats][svg]") {
  const int degree = GENERATE(1, 2, 5);
  MeshData mesh = samples::disk(degree, 9, {0.25, 0.5}, 1);
  samples::add_field(mesh, "x", 1, [](const Point& p) { return std::vector<double>{p.x * p.y}; });
  const MeshEdges edges = find_edges(mesh);
  const auto inner = std::ranges::find_if(edges.edges, [](const MeshEdge& edge) { return edge.constrained == none; });
  const auto outer = std::ranges::find_if(edges.edges, [](const MeshEdge& edge) { return edge.constrained != none; });
  REQUIRE((inner != edges.edges.end() && outer != edges.edges.end()));
  for (const double side : {1e-2, 1e-5, 1e-8, 1e-12})
    for (const auto& [edge, name] : {std::pair(*inner, "class=\"edges"), std::pair(*outer, "class=\"curves")})
      for (const char* color : {"field:x", "shape", "face"}) {
        CAPTURE(degree, side, name, color);
        // The picture is of a place on the edge.
        std::vector<double> rows;
        for (const Point& p : positions(mesh, edge.points)) rows.insert(rows.end(), {p.x, p.y});
        std::array<double, 2> at{};
        evaluate_polygon(degree, 2, rows, 0.4, at);
        const Vector half{side / 2, side / 2};
        SvgOptions options;
        options.box = Box{Point{at[0], at[1]} - half, Point{at[0], at[1]} + half};
        options.control_net = options.logical_mesh = true;
        options.isolines = {{"x", 5, {}}};
        const std::string svg = samples::svg_of(mesh, color, options);
        const PlacedDocument placed(mesh, options);
        const Point center = 0.5 * (placed.box().low + placed.box().high);
        const double width = placed.box().high.x - placed.box().low.x;
        std::size_t paths = 0;
        const std::string drawn = svg.substr(svg.find("<svg", 1));
        const std::regex data(" d=\"([^\"]*)\"");
        for (auto it = std::sregex_iterator(drawn.begin(), drawn.begin() + std::ptrdiff_t(drawn.find("</svg>")), data);
             it != std::sregex_iterator(); ++it, ++paths) {
          const std::vector<double> d = samples::numbers((*it)[1]);
          for (std::size_t k = 0; k + 1 < d.size(); k += 2) CHECK(distance({d[k], -d[k + 1]}, center) < 200 * width);
        }
        CHECK(paths >= 3);
        const std::size_t from = drawn.find('M', drawn.find(" d=", drawn.find(name)));
        const std::string piece = drawn.substr(from, drawn.find_first_of("M\"Z", from + 1) - from);
        const std::vector<double> d = samples::numbers(piece);
        REQUIRE(d.size() >= 4);
        // From so near the edge is straight, and passes the middle.
        const Point a{d[0], -d[1]}, b{d[d.size() - 2], -d[d.size() - 1]};
        if (degree == 1 || side < 1e-5) CHECK(std::abs(cross(b - a, center - a)) <= 1e-3 * width * distance(a, b));
      }
}

}  // namespace pliant
