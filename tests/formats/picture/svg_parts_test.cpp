// tests/formats/picture/svg_parts_test.cpp: what stands around and above the mesh in a picture: axes, keys, texts,
// arrows, isolines, inks.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>

#include "formats/picture/mesh_edges.h"
#include "formats/picture/svg.h"
#include "formats/picture/svg/text.h"
#include "formats/picture/svg/theme.h"
#include "pliant/geometry/invert_map.h"
#include "support/sample_meshes.h"
#include "support/svg_texts.h"

namespace pliant {
namespace {

using samples::numbers, samples::svg_of;

/// The first group of the first match.
std::string found(const std::string& text, const std::string& pattern) {
  std::smatch match;
  REQUIRE(std::regex_search(text, match, std::regex(pattern)));
  return match[1];
}

MeshData swirling_disk(int degree) {
  MeshData mesh = samples::disk(degree, 9, {0.25, 0.5}, 1);
  samples::add_field(mesh, "x", 1, [](const Point& p) { return std::vector<double>{p.x}; });
  samples::add_field(mesh, "u", 2, [](const Point& p) { return std::vector<double>{-p.y, p.x}; });
  return mesh;
}

/// A mesh of two elements, `width` by `height`.
MeshData rectangle(double width, double height) {
  samples::MeshBuilder builder(2);
  const PointId a = builder.add_vertex({0, 0}), b = builder.add_vertex({width, 0}),
                c = builder.add_vertex({width, height}), d = builder.add_vertex({0, height});
  builder.add_triangle(a, b, c, 0);
  builder.add_triangle(a, c, d, 0);
  builder.data().boundary.faces.push_back({"a face whose name is longer than what a column has room for, by far", {}});
  return std::move(builder.data());
}

/// The box of a text in the picture, as wide as in the widest of its fonts.
struct TextBox {
  std::string text;
  Box box;
};
std::vector<TextBox> text_boxes(const std::string& svg) {
  std::vector<TextBox> boxes;
  double group_size = 12;
  Vector shift{};
  const auto attribute = [](const std::string& line, const std::string& name) {
    std::smatch match;
    return std::regex_search(line, match, std::regex(" " + name + "=\"([^\"]*)\"")) ? match[1].str() : std::string();
  };
  std::istringstream lines(svg);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("<g class=")) {
      group_size = attribute(line, "font-size").empty() ? 12 : std::stod(attribute(line, "font-size"));
      const std::vector<double> by = numbers(attribute(line, "transform"));
      shift = by.size() == 2 ? Vector{by[0], by[1]} : Vector{};
    }
    if (!line.starts_with("<text")) continue;
    const std::string own = attribute(line, "font-size"), anchor = attribute(line, "text-anchor");
    const double size = own.empty() ? group_size : std::stod(own);
    std::string text = line.substr(line.find('>') + 1);
    text.erase(text.find("</text>"));
    const double width = text_width(text, size, !attribute(line, "font-weight").empty());
    const double from = anchor == "middle" ? -width / 2 : anchor == "end" ? -width : 0;
    const double up = -0.75 * size, down = 0.2 * size;
    Box box;
    if (const std::vector<double> turned = numbers(attribute(line, "transform")); turned.size() == 3) {
      const Point at = shift + Point{turned[0], turned[1]};
      box = {at + Vector{up, -from - width}, at + Vector{down, -from}};
    } else {
      const Point at = shift + Point{std::stod(attribute(line, "x")), std::stod(attribute(line, "y"))};
      box = {at + Vector{from, up}, at + Vector{from + width, down}};
    }
    boxes.push_back({text, box});
  }
  return boxes;
}

}  // namespace

TEST_CASE("texts neither overlap nor leave the picture, whatever sizes, titles, names and numbers are",
          "[formats][svg][property]") {
  const double width = GENERATE(50.0, 110.0, 170.0, 320.0, 1000.0);
  const auto [given_width, given_height] =
      GENERATE(table<double, double>({{1, 1}, {1000, 1}, {1, 40}, {3e-9, 1e-9}, {2e12, 1e12}, {1e150, 1e150}}));
  const double wide = given_width, high = given_height;  // clang 14 lets no lambda capture the others
  const std::string title = GENERATE(
      "Short", "A title of many words that stands in several lines wherever the picture is narrow, and further on",
      "Donaudampfschifffahrtsgesellschaftskapitaenswitwenrentenantragsformularvordruck");
  const double value = GENERATE(1e-300, -1.2345678e300);
  CAPTURE(width, wide, high, title, value);
  MeshData mesh = rectangle(wide, high);
  samples::add_field(mesh, "a name of a field that is long enough to be broken into lines", 1,
                     [&](const Point& p) { return std::vector<double>{value * (p.x / wide)}; });
  samples::add_field(mesh, "u", 2, [&](const Point& p) { return std::vector<double>{p.y / high, value}; });
  SvgOptions options;
  options.width = width;
  options.title = title;
  options.axes = options.scale_bar = true;
  options.unit = "mm";
  options.isolines = {{mesh.fields[0].name, 7, {}}};
  options.arrows = ArrowRequest{"u", 9};
  for (const std::string& color : {std::string("face"), "field:" + mesh.fields[0].name}) {
    const std::string svg = svg_of(mesh, color, options);
    const std::vector<double> size = numbers(found(svg, "viewBox=\"0 0 ([^\"]*)\""));
    const std::vector<TextBox> boxes = text_boxes(svg);
    for (std::size_t a = 0; a < boxes.size(); ++a) {
      INFO(boxes[a].text);
      CHECK(boxes[a].box.low.x >= -0.5);
      CHECK(boxes[a].box.low.y >= -0.5);
      CHECK(boxes[a].box.high.x <= size[0] + 0.5);
      CHECK(boxes[a].box.high.y <= size[1] + 0.5);
      for (std::size_t b = 0; b < a; ++b) {
        INFO(boxes[b].text);
        CHECK(!boxes[a].box.overlaps(boxes[b].box));
      }
    }
  }
}

TEST_CASE("the ends of the colour bar are the least and the greatest value, with their unit", "[formats][svg]") {
  const int degree = GENERATE(1, 2, 5);
  SvgOptions options;
  options.unit = "mm", options.color_unit = "K";
  const std::string svg = svg_of(swirling_disk(degree), "field:x", options);
  const double low = std::stod(found(svg, "data-min=\"([^\"]*)\"")),
               high = std::stod(found(svg, "data-max=\"([^\"]*)\""));
  // The disk's curve is round, but no circle: its least x is that of its control points or more.
  const MeshData disk = swirling_disk(degree);
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const MeshEdge& edge : find_edges(disk).edges)
    for (int k = 0; k <= 200; ++k) {
      std::vector<double> b(edge.points.size());
      for (std::size_t i = 0; i < b.size(); ++i) b[i] = disk.points[static_cast<std::size_t>(edge.points[i])].x;
      for (std::size_t n = b.size(); n > 1; --n)
        for (std::size_t i = 0; i + 1 < n; ++i) b[i] += (b[i + 1] - b[i]) * (k / 200.0);
      least = std::min(least, b[0]), most = std::max(most, b[0]);
    }
  CHECK(low == Approx(least).margin(1e-4));
  CHECK(high == Approx(most).margin(1e-4));
  CHECK(svg.find(">" + short_number(low) + "</text>") != std::string::npos);
  CHECK(svg.find(">" + short_number(high) + "</text>") != std::string::npos);
  CHECK(svg.find(">field x (K)</text>") != std::string::npos);
  options.color_unit.clear();
  CHECK(svg_of(disk, "edge_length", options).find("shortest edge (mm)") != std::string::npos);
  CHECK(svg_of(disk, "element_area", options).find("element area (mm\xC2\xB2)") != std::string::npos);
  CHECK(svg_of(disk, "shape", options).find("(mm)") == std::string::npos);
}

TEST_CASE("ticks stand where their numbers are, and the scale bar is as long as it says", "[formats][svg]") {
  const double scale = GENERATE(1.0, 0x1p-40, 0x1p100);
  CAPTURE(scale);
  MeshData mesh = swirling_disk(3);
  for (Point& p : mesh.points) p *= scale;
  SvgOptions options;
  options.axes = options.scale_bar = true;
  options.scale = 1.5;
  options.unit = "km";
  const std::string svg = svg_of(mesh, "none", options);
  const std::vector<double> place = numbers(found(svg, "<svg( x=[^>]* width=\"[^\"]*\")"));
  const std::vector<double> view = numbers(found(svg, "<svg x=[^>]* viewBox=\"([^\"]*)\""));
  const double unit = svg.find("data-unit") == std::string::npos ? 1 : std::stod(found(svg, "data-unit=\"([^\"]*)\""));
  const double left = place[0], drawn = place[2];
  const std::string axes = svg.substr(svg.find("class=\"axes\""));
  const std::regex tick(R"re(<text x="([^"]*)" y="[^"]*" text-anchor="middle">([^<]*)</text>)re");
  int count = 0;
  for (auto it = std::sregex_iterator(axes.begin(), axes.end(), tick); it != std::sregex_iterator(); ++it, ++count) {
    const double x = view[0] + (std::stod((*it)[1]) - left) / drawn * view[2];
    CHECK(x * unit == Approx(std::stod((*it)[2])).margin(1e-3 * scale));
  }
  CHECK(count >= 3);
  const double bar = numbers(found(svg, "class=\"scale-bar\"[^>]* d=\"M[^h]*h([^m]*)m"))[0];
  const double said = std::stod(found(svg, ">([-+.e0-9]*) km</text>"));
  CHECK(bar / drawn * view[2] * unit == Approx(said).epsilon(1e-4));
}

TEST_CASE("arrows lie in the mesh and have the field's values, the longest no longer than the grid's spacing",
          "[formats][svg]") {
  const int degree = GENERATE(1, 2, 4);
  const MeshData mesh = swirling_disk(degree);
  SvgOptions options;
  options.arrows = ArrowRequest{"u", 15};
  options.resolution = 1e-10;
  const std::string svg = svg_of(mesh, "none", options);
  const std::regex arrow(R"re(<path d="([^"]*)"><title>u\(([^,]*), ([^)]*)\) = \(([^,]*), ([^)]*)\)</title>)re");
  const auto is_inside = [&](const Point& p) {
    for (TriangleId t = 0; t < static_cast<TriangleId>(mesh.triangle_faces.size()); ++t)
      if (find_in_element(degree, element_net(mesh, t), p, 1e-8).answer == SearchAnswer::found) return true;
    return false;
  };
  int count = 0;
  double scale = 0;
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), arrow); it != std::sregex_iterator(); ++it, ++count) {
    const Point at{std::stod((*it)[2]), std::stod((*it)[3])};
    const Vector value{std::stod((*it)[4]), std::stod((*it)[5])};
    CHECK(value.x == Approx(-at.y).margin(1e-14));
    CHECK(value.y == Approx(at.x).margin(1e-14));
    const std::vector<double> d = numbers((*it)[1]);
    if (d.size() != 14) continue;  // a dot
    const Point tail = 0.5 * Point{d[0] + d[12], -d[1] - d[13]}, tip{d[6], -d[7]};
    for (int k = 0; k <= 4; ++k) CHECK(is_inside(tail + k / 4.0 * (tip - tail)));
    CHECK(std::abs(cross(tip - tail, value)) <= 1e-7);
    CHECK(dot(tip - tail, value) > 0);
    if (scale == 0) scale = distance(tail, tip) / length(value);
    CHECK(distance(tail, tip) == Approx(scale * length(value)).epsilon(1e-6));
    CHECK(distance(tail, tip) <= 2.2 / 15);
  }
  CHECK(count > 100);
  // The key tells what a length stands for.
  const std::vector<double> key = numbers(found(svg, "class=\"key-arrow\"[^>]* d=\"([^\"]*)\""));
  const double drawn = numbers(found(svg, "<svg width=\"([^\"]*)\""))[0];
  const double pixel = numbers(found(svg, "<svg width=\"[^>]*viewBox=\"([^\"]*)\""))[2] / drawn;
  const double said = std::stod(found(svg, R"re(>\|u\| = ([^<]*)</text>)re"));
  CHECK((key[6] - key[0]) * pixel == Approx(scale * said).epsilon(1e-3));
}

TEST_CASE("isolines stand in the picture with their values, closed where they are", "[formats][svg]") {
  const MeshData mesh = swirling_disk(3);
  SvgOptions options;
  options.isolines = {{"x", 10, {0.125, 7}}, {"u", 4, {}}};
  const std::string svg = svg_of(mesh, "none", options);
  const std::string line = found(svg, "class=\"isoline\" data-value=\"0.125\" d=\"([^\"]*)\"");
  CHECK(line.find('Z') == std::string::npos);
  const std::vector<double> d = numbers(line);
  for (std::size_t k = 0; k < d.size(); k += 2) CHECK(d[k] == Approx(0.125).margin(2e-5));
  CHECK(svg.find("data-value=\"7\"") == std::string::npos);
  std::size_t closed = 0;
  for (std::size_t at = svg.find("id=\"isoline1-"); at != std::string::npos; at = svg.find("id=\"isoline1-", at + 1))
    closed += svg.substr(at, svg.find("/>", at) - at).find('Z') != std::string::npos ? 1 : 0;
  CHECK(closed >= 1);  // circles around the origin
  CHECK(svg.find(">x = 0.125, 7</text>") != std::string::npos);
  options.isolines = {{"heat", 10, {}}};
  CHECK_THROWS_WITH(svg_of(mesh, "none", options), Catch::StartsWith("--isolines: the mesh has no field 'heat'"));
  options.isolines.clear();
  options.arrows = ArrowRequest{"x"};
  CHECK_THROWS_WITH(svg_of(mesh, "none", options), Catch::Contains("it has u"));
}

TEST_CASE("lines have the ink that is seen on the colours beneath", "[formats][svg]") {
  const std::string name = GENERATE("light", "dark", "print");
  const Theme& theme = *find_theme(name);
  const Colormap& map = *find_colormap("viridis");
  MeshData mesh = swirling_disk(2);
  for (const double place : {0.0, 1.0}) {
    CAPTURE(name, place);
    SvgOptions options;
    options.theme = name;
    options.map = &map;
    options.range = place == 0 ? ValueRange{5, 9} : ValueRange{-9, -5};  // all values are at one end
    const std::string svg = svg_of(mesh, "field:x", options);
    const Rgb beneath = map.at(place);
    std::size_t drawn = 0;
    const std::regex path(R"re(<path class="edges[^>]* stroke="(#[0-9a-f]*)"[^>]* d="([^"]*)")re");
    for (auto it = std::sregex_iterator(svg.begin(), svg.end(), path); it != std::sregex_iterator(); ++it) {
      if ((*it)[2].length() == 0) continue;
      const Rgb ink = (*it)[1] == hex(theme.ink) ? theme.ink : theme.other_ink;
      CHECK(contrast(ink, beneath) > 3);
      ++drawn;
    }
    CHECK(drawn == 1);
    CHECK(contrast(theme.text, theme.paper) > 7);
    CHECK(contrast(theme.ink, theme.paper) > 7);
  }
}

TEST_CASE("an edge that passes from dark to light is cut, and its parts are the whole edge", "[formats][svg]") {
  samples::MeshBuilder builder(2);
  MeshData mesh = rectangle(8, 1);
  samples::add_field(mesh, "x", 1, [](const Point& p) { return std::vector<double>{p.x}; });
  const std::string svg = svg_of(mesh, "field:x");
  std::vector<double> ends;
  const std::regex path(R"re(<path class="edges[^>]* d="M([^" ]*) [^"]*L([^" ]*) [^"]*")re");
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), path); it != std::sregex_iterator(); ++it) {
    if ((*it)[0].str().find("M0 0L8 -1") != std::string::npos) FAIL("the diagonal is not cut");
    ends.push_back(std::stod((*it)[1]));
  }
  CHECK(ends.size() == 2);
}

TEST_CASE("the map of the print theme and viridis grow evenly lighter or darker, so that greys keep the order",
          "[formats][svg]") {
  const Rgb white{1, 1, 1};
  for (const char* name : {"grey", "viridis", "magma", "plasma"}) {
    const Colormap& map = *find_colormap(name);
    const double sign = contrast(white, map.at(1)) > contrast(white, map.at(0)) ? 1 : -1;
    for (int k = 0; k < 20; ++k)
      CHECK(sign * (contrast(white, map.at((k + 1) / 20.0)) - contrast(white, map.at(k / 20.0))) > 0);
  }
  CHECK(find_colormap(find_theme("print")->map)->name == "grey");
}

TEST_CASE("texts of the command line cannot break the picture", "[formats][svg]") {
  SvgOptions options;
  options.title = "a < b & \"c\" \x01 \xff\xc3 \xed\xa0\x80 \xef\xbf\xbf é";
  options.unit = "<µm>";
  options.axes = true;
  const std::string svg = svg_of(swirling_disk(2), "none", options);
  CHECK(svg.find("<title>a &lt; b &amp; &quot;c&quot; \xEF\xBF\xBD ") != std::string::npos);
  CHECK(svg.find('\xff') == std::string::npos);
  CHECK(svg.find("\xed\xa0\x80") == std::string::npos);
  CHECK(svg.find("x (&lt;µm&gt;)") != std::string::npos);
}

TEST_CASE("the layers of control nets and of the logical mesh have every leg and every edge once", "[formats][svg]") {
  const int degree = GENERATE(1, 3);
  const MeshData mesh = swirling_disk(degree);
  SvgOptions options;
  options.logical_mesh = true;
  const std::string svg = svg_of(mesh, "none", options);
  const std::string data = found(svg, "class=\"logical-mesh\"[^>]* d=\"([^\"]*)\"");
  CHECK(std::count(data.begin(), data.end(), 'M') == static_cast<long>(find_edges(mesh).edges.size()));
  CHECK(std::count(data.begin(), data.end(), 'L') == static_cast<long>(find_edges(mesh).edges.size()));
  CHECK(svg.find("control-net") == std::string::npos);
}

}  // namespace pliant
