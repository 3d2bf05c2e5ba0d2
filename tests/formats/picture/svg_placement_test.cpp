// tests/formats/picture/svg_placement_test.cpp: meshes far from the origin are drawn about an origin of their own.
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>

#include "formats/picture/svg.h"
#include "formats/picture/svg/placement.h"
#include "support/sample_meshes.h"

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

}  // namespace pliant
