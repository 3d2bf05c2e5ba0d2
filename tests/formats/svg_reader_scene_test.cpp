// tests/formats/svg_reader_scene_test.cpp: which parts of a drawing are filled: styles, use, viewports, units,
// warnings.
#include <catch2/catch.hpp>

#include "formats/svg_import/svg_reader.h"

using namespace pliant;

namespace {

std::string scene(const std::string& content, const std::string& attributes = "") {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' " + attributes + ">\n" +
         content + "</svg>";
}

/// Names of the faces, joined.
std::string faces(const std::string& content, const std::string& attributes = "") {
  std::string out;
  for (const Face& face : read_svg(scene(content, attributes)).boundary.faces)
    out += (out.empty() ? "" : ", ") + face.name;
  return out;
}

Box box_of(const std::string& content, const std::string& attributes = "") {
  return bounding_box(read_svg(scene(content, attributes)).boundary);
}
bool is_box(const Box& box, double x0, double y0, double x1, double y1) {
  const auto near = [](double a, double b) { return a == Approx(b).margin(1e-12); };
  INFO(box.low.x << " " << -box.high.y << " " << box.high.x << " " << -box.low.y);
  CHECK((near(box.low.x, x0) && near(-box.high.y, y0) && near(box.high.x, x1) && near(-box.low.y, y1)));
  return true;
}

/// A square of size 1 at (at, 0).
std::string square(int at, const std::string& attributes) {
  return "<rect x='" + std::to_string(2 * at) + "' width='1' height='1' " + attributes + "/>";
}

std::string scene_warnings(const std::string& content) {
  std::string out;
  for (const std::string& text : read_svg(scene(content)).warnings) out += text + "\n";
  return out;
}

}  // namespace

TEST_CASE("faces are named by id, or by kind and number, and no two alike", "[svg]") {
  CHECK(faces(square(0, "id='a'") + square(1, "") + square(2, "id='a'") + "<circle r='1' cy='9'/>" +
              square(3, "id='ö'") + square(4, "id='a (2)'") + square(5, "id=''")) ==
        "a, rect 2, a (2), circle 1, ö, a (2) (2), rect 6");
}

TEST_CASE("what has no fill or is not shown is left out and counted", "[svg]") {
  const SvgImport import = read_svg(scene(
      square(0, "id='in'") + square(1, "fill='none'") + square(2, "style='fill:none'") + square(3, "fill-opacity='0'") +
      square(4, "display='none'") + square(5, "visibility='hidden'") + "<g style='display:none'>" + square(6, "") +
      square(7, "") + "</g><g opacity='0'>" + square(8, "") + "</g><defs>" + square(9, "") + "</defs>" +
      "<g fill='none'>" + square(10, "") + square(11, "fill='red' id='back'") + "</g>" + "<g visibility='hidden'>" +
      square(12, "visibility='visible' id='seen'") + "</g><line x2='9' y2='9'/>" + square(13, "fill='transparent'") +
      "<rect width='0' height='4'/><path/><path d=''/><path d='M9 9'/>"));
  REQUIRE(import.boundary.faces.size() == 3);
  CHECK(import.boundary.faces[0].name == "in");
  CHECK(import.boundary.faces[1].name == "back");
  CHECK(import.boundary.faces[2].name == "seen");
  CHECK(import.unfilled == 7);  // a line has no inside
  CHECK(import.hidden == 4);
  CHECK(import.warnings.empty());
}

TEST_CASE("style sheets select by element, class and id, the more specific ones first", "[svg]") {
  const std::string sheet = R"(<style type="text/css"><![CDATA[
    /* fill: none here } */ .none, .empty { fill: none; stroke: none }
    rect.some { fill : none } #kept { fill:blue } * { fill-rule: evenodd }
    .gone { display:none !important } @charset "x"; .quoted { fill: url("#a;}b") none }
  ]]></style>)";
  CHECK(faces(sheet + square(0, "class='none' id='a'") + square(1, "class='x empty' id='b'") +
              square(2, "class='some' id='c'") + square(3, "class='none' id='kept'") + square(4, "id='d'") +
              square(5, "class='none' style='fill:red' id='e'") + square(6, "class='gone' style='display:inline'") +
              square(7, "fill='none' class='other' id='f'")) == "kept, d, e");
  // The later of two rules of equal weight wins; a class beats an element, the sheet beats the attribute.
  CHECK(faces("<style>.a{fill:none}.b{fill:red}rect{fill:none}</style>" + square(0, "class='b a' id='x'") +
              square(1, "class='a' fill='red'")) == "x");
}

TEST_CASE("what a style sheet has beyond simple selectors is named in a warning", "[svg]") {
  const std::string text = scene_warnings(
      "<style>g rect{fill:none} rect:hover{fill:none} @media print{rect{fill:none}} "
      "@import 'x.css'; circle{fill:none}</style>" +
      square(0, "id='a'"));
  CHECK_THAT(text, Catch::Contains("style sheet rules whose selector is not simple are not read (2 times)"));
  CHECK_THAT(text, Catch::Contains("rules @media of style sheets are not read"));
  CHECK_THAT(text, Catch::Contains("rules @import of style sheets are not read"));
}

TEST_CASE("each kind of thing that is not read is named in one warning", "[svg]") {
  const std::string text = scene_warnings(
      "<defs><linearGradient id='g'/><pattern id='p'/><clipPath id='c'/></defs><g clip-path='url(#c)'>" +
      square(0, "fill='url(#g)' stroke='red'") + square(1, "stroke='blue'") + "<line x2='1' stroke='red'/></g>" +
      square(2, "fill='url(#p)'") + square(3, "fill='url(#nowhere) red'") +
      square(4, "mask='url(#m)' filter='url(#f)'") + square(5, "style='transform:rotate(3deg)'") +
      "<text>a</text><text>b</text><image/><use/><use href='other.svg#x'/><use href='#nowhere'/>" +
      "<animate/><flowRoot/><script/><foreignObject/>" + square(6, "fill='url(#nowhere)'"));
  for (const char* expected :
       {"strokes are not read (3 times, first at line 2)", "a gradient is taken for a colour (line 2)",
        "a pattern is taken for a colour", "clip paths do not cut anything off", "masks do not hide anything",
        "filters change nothing", "text is not read (2 times", "image is not read (line 2)",
        "use without href shows nothing", "other files are not read (use)",
        "use refers to an element that does not exist", "animation is not run", "elements flowRoot are not read",
        "scripts are not run", "foreignObject is not read",
        "a fill or stroke refers to a paint that does not exist (2 times"})
    CHECK_THAT(text, Catch::Contains(expected));
  CHECK(std::count(text.begin(), text.end(), '\n') == 16);
}

TEST_CASE("use shows an element again, at its place, with its inherited style", "[svg]") {
  const std::string defs =
      "<defs><g id='pair'><rect id='r' width='1' height='1'/><rect x='2' width='1' height='1' "
      "fill='none'/></g></defs>";
  is_box(box_of(defs + "<use href='#pair' x='5' y='7'/>"), 5, 7, 6, 8);
  is_box(box_of(defs + "<use xlink:href='#pair' transform='scale(2)' x='5'/>"), 10, 0, 12, 2);
  is_box(box_of(defs + "<use href='#r' xlink:href='#nowhere' x='1'/>"), 1, 0, 2, 1);
  CHECK(faces(defs + "<use href='#r'/><use href='#r' x='4' id='second'/><use id='third' href='#pair' y='5'/>") ==
        "r, r (2), r (3)");
  CHECK(faces("<defs><path id='' d='M0 0h1v1z'/></defs>" + square(0, "id='x'")) == "x");
  CHECK(faces("<defs><g id='g'><path d='M0 0h1v1z'/></g></defs><use id='shown' href='#g'/>") == "shown");
  // The fill of the use is inherited.
  CHECK(faces(defs + "<use href='#r' fill='none'/>" + square(5, "id='only'")) == "only");
}

TEST_CASE("symbols and nested drawings fit their viewBox into their viewport", "[svg]") {
  const std::string symbol =
      "<symbol id='s' viewBox='0 0 10 10' overflow='visible'><rect width='10' height='10'/></symbol>";
  is_box(box_of(symbol + "<use href='#s' x='1' y='2' width='20' height='20'/>"), 1, 2, 21, 22);
  is_box(box_of(symbol + "<use href='#s' width='40' height='20'/>"), 10, 0, 30, 20);
  const auto nested = [](const std::string& attributes) {
    return "<svg x='5' y='5' width='40' height='20' viewBox='0 0 10 10' overflow='visible' " + attributes +
           "><rect width='10' height='100%'/></svg>";
  };
  is_box(box_of(nested("")), 15, 5, 35, 25);
  is_box(box_of(nested("preserveAspectRatio='none'")), 5, 5, 45, 25);
  is_box(box_of(nested("preserveAspectRatio='xMinYMax'")), 5, 5, 25, 25);
  is_box(box_of(nested("preserveAspectRatio='xMaxYMid meet'")), 25, 5, 45, 25);
  is_box(box_of(nested("preserveAspectRatio='xMidYMin slice'")), 5, 5, 45, 45);
  is_box(box_of(nested("preserveAspectRatio='xMidYMax slice'")), 5, -15, 45, 25);
  is_box(box_of("<svg><rect width='50%' height='25%'/></svg>", "viewBox='0 0 40 80'"), 0, 0, 20, 20);
}

TEST_CASE("lengths have units, 96 to the inch, and percentages of the viewport", "[svg]") {
  const auto width = [](const std::string& length, const std::string& attributes = "") {
    const Box box = box_of("<rect height='1' width='" + length + "'/>", attributes);
    return box.high.x - box.low.x;
  };
  CHECK(width("7") == 7);
  CHECK(width("7px") == 7);
  CHECK(width("1in") == 96);
  CHECK(width("2.54cm") == Approx(96));
  CHECK(width("25.4mm") == Approx(96));
  CHECK(width("72pt") == Approx(96));
  CHECK(width("6pc") == 96);
  CHECK(width("50%", "viewBox='0 0 30 40'") == 15);
  CHECK(width("50%", "width='1in' height='1in'") == 48);
  CHECK(width("50%", "viewBox='0 0 30 40' width='300' height='400'") == 15);
  const Box circle = box_of("<circle cx='50' cy='50' r='10%'/>", "viewBox='0 0 30 40'");
  CHECK(circle.high.x == Approx(50 + std::hypot(30, 40) / std::sqrt(2) / 10).epsilon(1e-3));
}

TEST_CASE("switch shows the first child that has no conditions or speaks English", "[svg]") {
  CHECK(faces("<switch><foreignObject/><rect requiredExtensions='x' width='1' height='1'/><rect systemLanguage='de' "
              "width='2' height='2'/><rect id='c' systemLanguage='en-GB' width='1' height='1'/>" +
              square(5, "") + "</switch>") == "c");
}

TEST_CASE("elements of other namespaces are passed over, and a drawing without one is read", "[svg]") {
  CHECK(faces("<o:rect xmlns:o='urn:other' width='9' height='9'/><o:g xmlns:o='urn:other'>" + square(1, "") + "</o:g>" +
              square(0, "id='a'")) == "a");
  CHECK(read_svg("<svg><rect id='a' width='1' height='1'/></svg>").boundary.faces.at(0).name == "a");
  CHECK(read_svg("<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:rect id='a' width='1' height='1'/><rect width='4' "
                 "height='4'/></s:svg>")
            .boundary.faces.size() == 1);
  // As Adobe Illustrator writes it.
  CHECK(read_svg("<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'http://www.w3.org/x.dtd' [ <!ENTITY ns_svg "
                 "'http://www.w3.org/2000/svg'> ]><svg xmlns='&ns_svg;'><rect width='1' height='1'/></svg>")
            .boundary.faces.size() == 1);
}
