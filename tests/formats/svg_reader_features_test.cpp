// tests/formats/svg_reader_features_test.cpp: each row of formats/svg_import.md is read, or named when it is met.
#include <catch2/catch.hpp>
#include <random>

#include "formats/svg_import/paint.h"
#include "formats/svg_import/svg_reader.h"

using namespace pliant;

namespace {

SvgImport read(const std::string& content, const std::string& attributes = "viewBox='0 0 100 100'") {
  return read_svg(
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' " +
      attributes + ">" + content + "</svg>");
}

/// "x0 y0 x1 y1" of the drawing, y downwards.
std::string box(const std::string& content, const std::string& attributes = "viewBox='0 0 100 100'") {
  const Box found = bounding_box(read(content, attributes).boundary);
  std::string out;
  for (const double value : {found.low.x, -found.high.y, found.high.x, -found.low.y}) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", value == 0 ? 0 : value);
    out += (out.empty() ? "" : " ") + std::string(digits);
  }
  return out;
}

std::string names(const std::string& content) {
  std::string out;
  for (const Face& face : read(content).boundary.faces) out += (out.empty() ? "" : ", ") + face.name;
  return out;
}

std::string warnings(const std::string& content, const std::string& attributes = "viewBox='0 0 100 100'") {
  std::string out;
  for (const std::string& text : read(content, attributes).warnings) out += text + "\n";
  return out;
}

/// Is a square with these attributes filled?
bool is_filled(const std::string& attributes, const std::string& around = "") {
  return read("<g " + around + "><rect id='a' width='1' height='1' " + attributes +
              "/></g><rect x='9' width='1' height='1'/>")
             .unfilled == 0;
}

const std::string rect = "<rect x='40' y='10' width='20' height='40' ";

}  // namespace

TEST_CASE("transform-origin moves the origin of a transform", "[svg]") {
  CHECK(box(rect + "transform='rotate(90)' transform-origin='50 50'/>") == "50 40 90 60");
  CHECK(box(rect + "transform='rotate(90)' transform-origin='50% 50%'/>") == "50 40 90 60");
  CHECK(box(rect + "transform='rotate(90)' transform-origin='center'/>") == "50 40 90 60");
  CHECK(box(rect + "transform='rotate(90)' style='transform-origin: 50px 50px'/>") == "50 40 90 60");
  CHECK(box(rect + "transform='scale(0.5)' transform-origin='right bottom'/>") == "70 55 80 75");
  CHECK(box(rect + "transform='scale(0.5)' transform-origin='bottom left'/>") == "20 55 30 75");
  CHECK(box(rect + "transform='scale(0.5)' transform-origin='top'/>") == "45 5 55 25");
  CHECK(box(rect + "transform='scale(0.5)' transform-origin='40'/>") == "40 30 50 50");
  CHECK(box(rect + "transform-origin='40 3'/>") == "40 10 60 50");
  CHECK(box("<g transform='scale(2)' transform-origin='5em 1em' font-size='10'><rect x='50' y='10' width='5' "
            "height='5'/></g>") == "50 10 60 20");
  CHECK_THROWS_WITH(read(rect + "transform='scale(2)' transform-origin='x'/>"), Catch::Contains("transform-origin"));
  CHECK_THAT(warnings(rect + "transform='scale(0.5)' transform-origin='1 1' style='transform-box:fill-box'/>"),
             Catch::Contains("transform-box"));
}

TEST_CASE("transforms in styles are read in CSS's spelling, or named", "[svg]") {
  CHECK(box(rect + "style='transform: translate(10px, 20px) scale(.5)'/>") == "30 25 40 45");
  CHECK(box(rect + "transform='scale(9)' style='transform:none'/>") == "40 10 60 50");
  for (const char* quarter : {"90deg", "0.25turn", "100grad"})
    CHECK(box(rect + "style='transform-origin:50px 50px;transform:rotate(" + quarter + ")'/>") == "50 40 90 60");
  CHECK(box("<style>rect{transform:rotate(90deg);transform-origin:center}</style>" + rect + "/>") == "50 40 90 60");
  CHECK_THAT(warnings(rect + "style='transform:rotate3d(1,0,0,3deg)'/>"), Catch::Contains("a transform in a style"));
  for (const char* property : {"translate", "rotate", "scale", "offset-path"})
    CHECK_THAT(warnings(rect + "style='" + property + ":2'/>"), Catch::Contains(std::string(property) + " in a style"));
}

TEST_CASE("colours without alpha do not fill, in every spelling", "[svg]") {
  for (const char* none : {"none",
                           "NONE",
                           "transparent",
                           "Transparent",
                           "#0000",
                           "#abc0",
                           "#12345600",
                           "rgba(1,2,3,0)",
                           "rgba(1, 2, 3, 0%)",
                           "rgb(1 2 3 / 0)",
                           "rgb(1 2 3/0%)",
                           "rgb(1,2,3,0.0)",
                           "hsla(120, 50%, 50%, 0)",
                           "hsl(120deg 50% 50% / 0)",
                           "hwb(1 2% 3% / 0)",
                           "lab(50% 1 2 / 0)",
                           "lch(50% 1 2 / none)",
                           "oklab(0.5 0 0 / 0)",
                           "oklch(0.5 0 0 / 0)",
                           "color(srgb 1 0 0 / 0)",
                           "RGBA(1,2,3,0)",
                           "url(#nowhere) transparent",
                           "url(#nowhere)"}) {
    INFO(none);
    CHECK_FALSE(is_filled(std::string("fill='") + none + "'"));
    CHECK_FALSE(is_filled(std::string("style='fill:") + none + "'"));
  }
  for (const char* some :
       {"red", "Red", "#000", "#000f", "#12345601", "rgba(0,0,0,0.01)", "rgb(0 0 0 / 1%)", "rgb(0,0,0)", "rgb(0 0 0)",
        "hsl(0 0% 0%)", "color(srgb 0 0 0)", "lab(0 0 0)", "currentColor", "rebeccapurple",
        "#CD853F icc-color(acme, 0.1, 0, 0, 0)", "device-cmyk(0 0 0 0)", "url(#nowhere) red", "WindowText"}) {
    INFO(some);
    CHECK(is_filled(std::string("fill='") + some + "'"));
  }
}

TEST_CASE("currentColor is the property color, and words that are no paint are passed over", "[svg]") {
  CHECK_FALSE(is_filled("fill='currentColor' color='transparent'"));
  CHECK_FALSE(is_filled("fill='currentcolor'", "color='#0000'"));
  CHECK(is_filled("fill='currentColor' color='red'", "color='#0000'"));
  CHECK_FALSE(is_filled("fill='currentColor' color='currentColor'", "color='#0000'"));
  CHECK_FALSE(is_filled("fill='no-such-colour'", "fill='none'"));
  CHECK(is_filled("fill='no-such-colour'"));
  CHECK_FALSE(is_filled("fill='#12345'", "fill='none'"));
  CHECK_FALSE(is_filled("fill='unset'", "fill='none'"));
  CHECK(is_filled("fill='initial'", "fill='none'"));
  CHECK_THAT(warnings(rect + "fill='var(--x)'/>"), Catch::Contains("a paint that is not understood"));
}

TEST_CASE("opacities are numbers or percentages", "[svg]") {
  CHECK_FALSE(is_filled("fill-opacity='0%'"));
  CHECK_FALSE(is_filled("opacity='-1'"));
  CHECK_FALSE(is_filled("", "opacity='0%'"));
  CHECK(is_filled("fill-opacity='1%'"));
  CHECK(is_filled("fill-opacity='x'"));
}

TEST_CASE("context-fill and context-stroke are those of the use around", "[svg]") {
  const auto unfilled = [](const std::string& paint, const std::string& use) {
    return read("<defs><rect id='a' width='1' height='1' fill='" + paint + "'/></defs><use href='#a' " + use +
                "/><rect x='9' width='1' height='1'/>")
        .unfilled;
  };
  CHECK(unfilled("context-fill", "fill='red'") == 0);
  CHECK(unfilled("context-fill", "fill='none'") == 1);
  CHECK(unfilled("context-stroke", "stroke='red'") == 0);
  CHECK(unfilled("context-stroke", "") == 1);
  CHECK_FALSE(is_filled("fill='context-fill'"));  // no context
}

TEST_CASE("lengths know the font and the window", "[svg]") {
  const std::string in = "<rect x='1em' y='1em' width='2em' height='1em'/>";
  CHECK(box("<g font-size='10'>" + in + "</g>") == "10 10 30 20");
  CHECK(box(in) == "16 16 48 32");
  CHECK(box("<g style='font-size:20px'><g font-size='50%'>" + in + "</g></g>") == "10 10 30 20");
  CHECK(box("<g font-size='20'><g font-size='.5em'>" + in + "</g></g>") == "10 10 30 20");
  CHECK(box("<g style='font: bold 10px/2 serif'>" + in + "</g>") == "10 10 30 20");
  CHECK(box("<g font-size='large'><rect width='1em' height='1em'/></g>") == "0 0 18 18");
  CHECK(box("<g font-size='20'><rect width='1ex' height='1ch'/></g>") == "0 0 10 10");
  CHECK(box("<g font-size='20'><rect width='2rem' height='1rem'/></g>", "viewBox='0 0 9 9' font-size='3'") ==
        "0 0 6 3");
  CHECK(box("<rect width='50vw' height='10vh'/>", "width='30' height='40' viewBox='0 0 3 4'") == "0 0 15 4");
  CHECK(box("<rect width='10vmin' height='10vmax'/>", "width='30' height='40'") == "0 0 3 4");
  CHECK(box("<rect width='50%' height='50%'/>", "width='10em' height='5em' font-size='2'") == "0 0 10 5");
  CHECK(box("<rect width='1PX' height='1Cm'/>") == "0 0 1 37.7953");
  CHECK_THROWS_WITH(read("<rect width='50vw' height='1'/>"), Catch::Contains("width is '50vw'"));
  CHECK_THROWS_WITH(read("<rect width='calc(1px + 1em)' height='1'/>"), Catch::Contains("width, offset 0"));
  CHECK_THAT(warnings("<g font-size='huge'>" + in + "</g>"), Catch::Contains("a font-size that is not understood"));
}

TEST_CASE("lengths and outlines in styles take the place of attributes, or are named", "[svg]") {
  CHECK(box("<rect x='9' style='x:1px;y:2px;width:3px;height:4px'/>") == "1 2 4 6");
  CHECK(box("<style>circle{r:5px;cx:10px}</style><circle r='1' cy='10'/>") == "5 5 15 15");
  CHECK(box("<path d='M0 0h1v1z' style='d:path(\"M0 0h7v7z\")'/>") == "0 0 7 7");
  CHECK_THAT(warnings("<rect width='1' height='1' style='width:3'/>"), Catch::Contains("a length without a unit"));
  CHECK_THAT(warnings("<path d='M0 0h1v1z' style='d:inset(3px)'/>"), Catch::Contains("an outline in a style"));
}

TEST_CASE("markers are named, where there may be any", "[svg]") {
  const std::string path = "<path d='M10 45h50v10h-50z' ";
  for (const char* property : {"marker-start", "marker-mid", "marker-end"}) {
    CHECK_THAT(warnings(path + property + "='url(#m)'/>"), Catch::Contains("markers are not drawn (line 1)"));
    CHECK_THAT(warnings("<g " + std::string(property) + "='url(#m)'>" + path + "/></g>"), Catch::Contains("markers"));
  }
  CHECK_THAT(warnings(path + "style='marker:url(#m)'/>"), Catch::Contains("markers are not drawn"));
  CHECK_THAT(warnings(rect + "/><line x2='1' marker-end='url(#m)'/>"), Catch::Contains("markers are not drawn"));
  CHECK(warnings("<g marker-start='url(#m)'>" + path + "marker-start='none'/></g>").empty());
  CHECK(warnings(rect + "marker-start='url(#m)'/>").empty());  // a rect has none
}

TEST_CASE("what a viewport would cut off is named, and only that", "[svg]") {
  const std::string inside = "<rect width='10' height='10'/>", jutting = "<circle cx='10' cy='5' r='5'/>";
  const char* nested = "what juts out of a nested viewport is not cut off";
  for (const std::string& kind : {std::string("viewBox='0 0 10 10'"), std::string()}) {
    const auto symbol = [&](const std::string& content, const std::string& attributes = "") {
      return warnings("<symbol id='s' " + kind + " " + attributes + ">" + content +
                      "</symbol><use href='#s' x='9' width='10' height='10'/>");
    };
    CHECK(symbol(inside).empty());
    CHECK_THAT(symbol(jutting), Catch::Contains(nested));
    CHECK(symbol(jutting, "overflow='visible'").empty());
    CHECK(symbol(jutting, "style='overflow:visible'").empty());
  }
  CHECK_THAT(warnings("<svg width='10' height='10'>" + jutting + "</svg>"), Catch::Contains(nested));
  CHECK(warnings("<svg width='10' height='10'>" + inside + "</svg>").empty());
  CHECK_THAT(warnings(jutting, "viewBox='0 0 10 10'"), Catch::Contains("what juts out of the page is not cut off"));
  CHECK_THAT(warnings(jutting, "width='10' height='10'"), Catch::Contains("the page"));
  CHECK(warnings(inside, "viewBox='0 0 10 10'").empty());
  CHECK(warnings(jutting, "").empty());
  CHECK_THAT(warnings("<symbol id='s' refX='4'>" + inside + "</symbol><use href='#s'/>"), Catch::Contains("refX"));
}

TEST_CASE("conditions hold for every element, not only in a switch", "[svg]") {
  const std::string end = "<rect id='b' x='9' width='1' height='1'/>";
  const auto square = [&](const std::string& attributes) {
    return "<rect id='a' width='1' height='1' " + attributes + "/>" + end;
  };
  CHECK(names(square("systemLanguage='en'")) == "a, b");
  CHECK(names(square("systemLanguage='de, EN-gb'")) == "a, b");
  CHECK(names(square("systemLanguage='de'")) == "b");
  CHECK(names(square("systemLanguage='enx'")) == "b");
  CHECK(names(square("systemLanguage=''")) == "b");
  CHECK(names(square("requiredExtensions='x'")) == "b");
  CHECK_THAT(warnings(square("systemLanguage='de'")), Catch::Contains("for other languages than English"));
  CHECK(names("<switch><g systemLanguage='de'/><rect id='s' systemLanguage='fr,en' width='1' "
              "height='1'/><rect/></switch>") == "s");
}

TEST_CASE("labels and titles serve as names", "[svg]") {
  const auto named = [](const std::string& attributes, const std::string& content = "") {
    return names("<path d='M0 0h1v1z' " + attributes + ">" + content + "</path>");
  };
  CHECK(named("inkscape:label='left wing' id='wing'") == "left wing");
  CHECK(named("id='wing'", "<title>A wing</title>") == "wing");
  CHECK(named("id='path1234-5'", "<title> A \n wing </title>") == "A wing");
  CHECK(named("id='path1234-5'") == "path1234-5");
  CHECK(named("", "<desc>no</desc><title>wing</title>") == "wing");
  CHECK(named("id='path7'", "<title></title>") == "path7");
  CHECK(names("<defs><path id='' d='M0 0h1v1z'/><g id='x'><path d='M0 0h1v1z'/></g></defs>"
              "<use href='#x' inkscape:label='copy'/>") == "copy");
}

TEST_CASE("what else is not read is named", "[svg]") {
  CHECK_THAT(warnings("<rect width='1' height='1'><animate attributeName='x'/></rect>"),
             Catch::Contains("animation is not run"));
  CHECK_THAT(warnings("<style media='print'>rect{fill:none}</style>" + rect + "/>"),
             Catch::Contains("style sheets for"));
  CHECK(warnings("<style media='screen'>rect{fill:red}</style>" + rect + "/>").empty());
  CHECK_THAT(warnings(rect + "/>", "viewBox='0 0 0 9'"), Catch::Contains("a page without width"));
  const SvgImport sheet = read_svg("<?xml-stylesheet href='a.css'?><svg><rect width='1' height='1'/></svg>");
  REQUIRE(sheet.warnings.size() == 1);
  CHECK_THAT(sheet.warnings[0], Catch::Contains("style sheets of other files"));
  CHECK_THAT(warnings("<rect id='r' width='1' height='1' fill='url(#r) red'/>"), Catch::Contains("does not exist"));
}

TEST_CASE("a looser tolerance never takes more pieces, and a note tells what another would take", "[svg]") {
  const std::string drawing =
      "<path d='M20 50C34 10 76 8 102 22 94 52 52 70 20 50z'/><path d='M10 90C90 190 60 -90 90 95z'/>"
      "<ellipse cx='160' cy='48' rx='40' ry='13'/><path d='M0 200a30 50 -30 0 1 50 -25q9 40-10 70z'/>";
  const auto pieces = [&](double tolerance, int degree) {
    SvgReadOptions options;
    options.tolerance = tolerance;
    options.degree = degree;
    options.planar = true;
    return read_svg("<svg>" + drawing + "</svg>", options);
  };
  for (const int degree : {2, 3}) {
    long last = 1'000'000;
    for (double tolerance = 1e-9; tolerance <= 1; tolerance *= 1.5) {
      const long count = pieces(tolerance, degree).pieces;
      CAPTURE(tolerance, degree);
      CHECK(count <= last);
      last = count;
    }
  }
  const SvgImport import = pieces(1e-6, 2), cubic = pieces(1e-6, 3);
  REQUIRE(import.costs.size() == 1);
  CHECK(import.costs[0] == "tolerance 1e-06 made " + std::to_string(import.fitted) +
                               " spans of 8 cubic curves and arcs; --degree 3 takes " + std::to_string(cubic.pieces) +
                               " instead of " + std::to_string(import.pieces) + " spans in all, --tolerance 0.0001 " +
                               std::to_string(pieces(1e-4, 2).pieces) + " spans in all");
  CHECK(pieces(1e-1, 2).costs.empty());
  CHECK_THAT(read("<path d='M20 50C34 10 76 8 102 22z'/>").costs.at(0),
             Catch::Contains(" spans of 1 cubic curve; --degree 3 keeps them exactly, "));
}

TEST_CASE("a looser tolerance never takes more pieces of curves at random", "[svg][property]") {
  const unsigned seed = GENERATE(range(0U, 20U));
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto number = [&](int least, int most) {
    return std::to_string(least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1))) + " ";
  };
  std::string path = "M" + number(-99, 99) + number(-99, 99);
  for (int k = 0; k < 6; ++k) {
    if (random() % 3 == 0) {
      path += "A" + number(1, 300) + number(1, 300) + number(0, 180) + number(0, 1) + number(0, 1);
    } else {
      path += "C";
      for (int point = 0; point < 2; ++point) path += number(-199, 199) + number(-199, 199);
    }
    path += number(-99, 99) + number(-99, 99);
  }
  for (const int degree : {2, 3}) {
    long last = 1'000'000;
    for (double tolerance = 1e-8; tolerance <= 10; tolerance *= 1.7) {
      SvgReadOptions options;
      options.tolerance = tolerance;
      options.degree = degree;
      options.planar = true;
      long count = last;
      try {
        count = read_svg("<svg><path fill-rule='evenodd' d='" + path + "z'/></svg>", options).pieces;
      } catch (const InputError&) {  // so loose that nothing is left of the drawing
        CHECK(tolerance > 0.01);
      }
      CAPTURE(tolerance, degree, path);
      CHECK(count <= last);
      last = count;
    }
  }
}
