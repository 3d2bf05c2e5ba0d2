// tests/formats/page_rows_test.cpp: each row of the tables of formats/svg_import.md has a case here.
#include "tests/formats/page_rows.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "formats/svg_import/svg_reader.h"

using namespace pliant;

namespace {

/// "a, b: 0 0 4 4" (faces, and their box with y downwards), then the warnings, counts of what is left out, or the
/// error.
/// In front of the content `--planar ` or `--strokes ` (for areas) may stand.
std::string read_drawing(std::string content) {
  SvgReadOptions options;
  for (const std::string option : {"--planar ", "--strokes "}) {
    if (content.rfind(option, 0) != 0) continue;
    content.erase(0, option.size());
    options.planar = true;
    if (option == "--strokes ") options.strokes = Strokes::area;
  }
  try {
    const SvgImport import = read_svg(
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' viewBox='0 0 100 100'>" +
            content + "</svg>",
        options);
    std::string out;
    for (const Face& face : import.boundary.faces) out += (out.empty() ? "" : ", ") + face.name;
    const Box box = bounding_box(import.boundary);
    out += ":";
    for (const double x : {box.low.x, -box.high.y, box.high.x, -box.low.y}) out += " " + number(x);
    out += ", degree " + std::to_string(import.boundary.curves.front().spline.degree()) + "\n";
    for (const std::string& text : import.warnings) out += text + "\n";
    if (import.unfilled + import.hidden > 0)
      out += "unfilled " + std::to_string(import.unfilled) + ", hidden " + std::to_string(import.hidden);
    return out;
  } catch (const InputError& e) {
    return (e.pointer().empty() ? "" : e.pointer() + ": ") + e.what();
  }
}

std::string repeated(long times, const std::string& text) {
  std::string out;
  out.reserve(static_cast<std::size_t>(times) * text.size());
  for (long k = 0; k < times; ++k) out += text;
  return out;
}

/// A line of copies of a shape, ten times ten times ... as many.
std::string copies(const std::string& shape, int tens) {
  std::string out = "<defs><g id='u0'>" + shape + "</g>";
  for (int k = 1; k <= tens; ++k)
    out +=
        "<g id='u" + std::to_string(k) + "'>" + repeated(10, "<use href='#u" + std::to_string(k - 1) + "'/>") + "</g>";
  return out + "</defs><use href='#u" + std::to_string(tens) + "'/>";
}

/// A use of a use of ... a square.
std::string chain_of_uses(int length) {
  std::string out;
  for (int k = 0; k < length; ++k)
    out += "<use id='u" + std::to_string(k) + "' href='#u" + std::to_string(k + 1) + "'/>";
  return out + "<rect id='u" + std::to_string(length) + "' width='1' height='1'/>";
}

/// Clip paths, each of which is clipped by the next one.
std::string chain_of_clips(int length) {
  std::string out;
  for (int k = 0; k < length; ++k)
    out += "<clipPath id='c" + std::to_string(k) + "' clip-path='url(#c" + std::to_string(k + 1) + ")'/>";
  return out + "<clipPath id='c" + std::to_string(length) + "'/>";
}

const std::string end = "<rect id='b' x='9' width='1' height='1'/>";
std::string square(const std::string& attributes) { return "<rect id='a' width='4' height='4' " + attributes + "/>"; }

std::vector<Case> drawing_cases() {
  const std::string basic = "`rect`, `circle`, `ellipse`, `polygon`, `polyline`", groups = "`g`, `a`, `switch`",
                    viewports = "`svg`, `symbol`", opacity = "`fill-opacity`, `opacity`",
                    strokes =
                        "`stroke`, `stroke-width`, `stroke-opacity`, `stroke-linejoin`, `stroke-linecap`, "
                        "`stroke-miterlimit`, `stroke-dasharray`, `stroke-dashoffset`, `paint-order`",
                    shown = "`fill-rule`, `display`, `visibility`",
                    lengths = "`x`, `y`, `width`, `height`, `cx`, `cy`, `r`, `rx`, `ry`, `d`";
  return {
      {"`path`", "<path id='p' d='M1 1 3 1L3 2H5V6h-2v-1l-2 0z'/>", "p: 1 1 5 6, degree 1"},
      {"`path`", "<path id='p' d='M0 0Q2 4 4 0t4 0 0-4 q-4-2-8 4'/>", "p: 0 -6 10 4, degree 2"},
      {"`path`", "<path id='p' d='m0 0c0 4 4 4 4 0s-4-4-4 0zm9 0C9 1 8 1 8 0S9-1 9 0'/>", "p: 0 -3 9 3, degree 2"},
      {"`path`", "<path id='p' d='M.5.5a1 1 0 012 0A1 1 0 11.5.5z'/>", "p: 0.5 -0.5 2.5 1.5, degree 2"},
      {"`path`", "<path d='M0 0h1v'/>", "d, offset"},
      {basic, "<rect width='4' height='2'/>", "rect 1: 0 0 4 2, degree 1"},
      {basic, "<rect width='4' height='2' rx='1'/>", "rect 1: 0 0 4 2, degree 2"},
      {basic, "<circle cx='5' cy='5' r='2'/>", "circle 1: 3 3 7 7, degree 2"},
      {basic, "<ellipse cx='5' cy='5' rx='2' ry='3'/>", "ellipse 1: 3 2 7 8, degree 2"},
      {basic, "<polygon points='0,0 3,0 3,2'/>", "polygon 1: 0 0 3 2, degree 1"},
      {basic, "<polyline points='0 0 3 0 3 2'/>", "polyline 1: 0 0 3 2, degree 1"},
      {basic, "<line x2='9' y2='8'/>" + square(""), "a: 0 0 4 4"},
      {groups, "<g><a>" + square("") + "</a></g>", "a: 0 0 4 4"},
      {groups, "<switch><g systemLanguage='de'/>" + square("") + end + "</switch>", "a: 0 0 4 4"},
      {viewports, "<svg x='9' width='8' height='8' viewBox='0 0 4 4'>" + square("") + "</svg>", "a: 9 0 17 8"},
      {viewports, "<svg width='8' height='4' viewBox='0 0 4 4' preserveAspectRatio='xMaxYMid'>" + square("") + "</svg>",
       "a: 4 0 8 4"},
      {viewports, "<svg width='3' height='4'>" + square("") + "</svg>", "juts out of a nested viewport"},
      {viewports, "<rect width='400' height='4'/>", "juts out of the page"},
      {viewports,
       "<symbol id='s' refX='1' viewBox='0 0 4 4'>" + square("") + "</symbol><use href='#s' width='4' height='4'/>",
       "refX of a symbol moves nothing"},
      {"`use`", "<defs>" + square("") + "</defs><use href='#a' x='3' y='2'/>", "a: 3 2 7 6"},
      {"`use`", "<defs>" + square("") + "</defs><use xlink:href='#a'/>", "a: 0 0 4 4"},
      {"`use`", "<symbol id='s' viewBox='0 0 4 4'>" + square("") + "</symbol><use href='#s' width='8' height='8'/>",
       ": 0 0 8 8"},
      {"`use`", square("") + "<use href='x.svg#a'/>", "other files are not read (use)"},
      {"`style`",
       "<style>rect{fill:none}.c{fill:red!important}#b{fill:none}</style>" + square("class='c' style='fill:none'") +
           end,
       "a: 0 0 4 4, degree 1\nunfilled 1, hidden 0"},
      {"`style`", "<style media='print'>rect{fill:none}</style>" + square(""), "style sheets for"},
      {"`clipPath`",
       "--planar <clipPath id='c'><rect width='2' height='9'/></clipPath>" + square("clip-path='url(#c)'"),
       "a: 0 0 2 4"},
      {"`clip-path`, `clip-rule`",
       "--planar <clipPath id='c'><path clip-rule='evenodd' d='M0 0h4v4h-4zM1 0h4v4h-4z'/></clipPath>" +
           square("clip-path='url(#c)'"),
       "a: 0 0 1 4"},
      {"`clip-path`, `clip-rule`", "--planar " + square("clip-path='inset(1)'"), "is no url(#id)"},
      {strokes, "--strokes <line id='l' x2='8' stroke='red' stroke-width='2' stroke-linecap='square'/>",
       "l: -1 -1 9 1"},
      {strokes, "--strokes <line id='l' x2='8' stroke='red' stroke-dasharray='1' stroke-opacity='0'/>" + square(""),
       "unfilled 1"},
      {strokes, "--strokes <line x2='8' stroke='red' stroke-linejoin='arcs'/>", "taken for miter"},
      {strokes, "--strokes <line x2='8' stroke='red' vector-effect='non-scaling-stroke'/>", "vector-effect"},
      {strokes, "--strokes <line x2='8' stroke='red' pathLength='9' stroke-dasharray='1'/>", "pathLength"},
      {strokes, "--strokes <path fill='none' d='M0 0h9v9' stroke='red' stroke-miterlimit='1' stroke-dashoffset='3'/>",
       "path 1: 0 -0.5 9.5 9"},
      {strokes, "--strokes <rect width='4' height='4' stroke='red' stroke-width='2' paint-order='stroke'/>",
       "rect 1 stroke, rect 1: -1 -1 5 5"},
      {"dashes of a stroke", "--strokes <line x2='9' stroke='red' stroke-dasharray='1e-5'/>",
       "more than 100000 dashes"},
      {"lengths in `stroke-dasharray`, those of each stroke counted",
       "--strokes <g stroke='red' stroke-dasharray='" + repeated(2000, "1 ") + "'>" +
           repeated(1001, "<path d='M0 0h1'/>") + "</g>",
       "more than 2000000 lengths"},
      {"clip paths that clip each other", "--planar " + square("clip-path='url(#c0)'") + chain_of_clips(51),
       "more than 50 clip paths"},
      {"`title`", "<path id='path12' d='M0 0h1v1z'><title>wing</title></path>", "wing: 0 0 1 1"},
      {"`transform`", square("transform='translate(9,1)scale(2)rotate(90)'"), "a: 1 1 9 9"},
      {"`transform`", square("transform='matrix(1 0 0 2 3 4)'"), "a: 3 4 7 12"},
      {"`transform`", square("transform='skewX(45)'"), "a: 0 0 8 4"},
      {"`transform`", square("transform='skewY(45)'"), "a: 0 0 4 8"},
      {"`transform`", square("style='transform:translate(1px,2px)rotate(0.25turn)'"), "a: -3 2 1 6"},
      {"`transform`", square("style='transform:rotate(100grad)'"), "a: -4 0 0 4"},
      {"`transform`", square("style='transform:rotate(90deg)'"), "a: -4 0 0 4"},
      {"`transform`", square("style='transform:rotate(1.5707963267948966rad)'"), "a: -4 0"},
      {"`transform`", square("style='transform:rotateY(3deg)'"), "a transform in a style is not read"},
      {"`transform-origin`", square("transform='scale(2)' transform-origin='4 4'"), "a: -4 -4 4 4"},
      {"`transform-origin`", square("transform='scale(2)' transform-origin='50% 100%'"), "a: -50 -100 -42 -92"},
      {"`transform-origin`", square("transform='scale(2)' transform-origin='right top'"), "a: -100 0 -92 8"},
      {"`transform-origin`", square("transform='scale(2)' style='transform-box:fill-box'"),
       "transform-box is taken for view-box"},
      {"`fill`", square("fill='none'") + end, "unfilled 1"},
      {"`fill`", square("fill='rgb(1 2 3 / 0)'") + end, "unfilled 1"},
      {"`fill`", square("fill='currentColor' color='transparent'") + end, "unfilled 1"},
      {"`fill`", "<defs>" + square("fill='context-fill'") + "</defs><use href='#a' fill='none'/>" + end, "unfilled 1"},
      {"`fill`", "<defs>" + square("fill='context-stroke'") + "</defs><use href='#a'/>" + end, "unfilled 1"},
      {"`fill`", "<linearGradient id='g'/>" + square("fill='url(#g)'"), "a gradient is taken for a colour"},
      {"`fill`", "<pattern id='g'/>" + square("fill='url(#g)'"), "a pattern is taken for a colour"},
      {"`fill`", square("fill='var(--x)'"), "a paint that is not understood is passed over"},
      {opacity, square("fill-opacity='0'") + end, "unfilled 1"},
      {opacity, square("opacity='0%'") + end, "unfilled 1"},
      {opacity, square("opacity='1%'"), "a: 0 0 4 4"},
      {shown,
       "<path id='a' fill-rule='evenodd' d='M0 0h9v9h-9zM3 3h3v3h-3z'/><rect id='b' x='4' y='4' width='1' height='1'/>",
       "a, b: 0 0 9 9"},
      {shown, "<path id='a' d='M0 0h9v9h-9zM3 3h3v3h-3z'/><rect id='b' x='4' y='4' width='1' height='1'/>",
       "shapes cross, touch or lie over each other"},
      {shown, square("display='none'") + end, "hidden 1"},
      {shown, square("visibility='hidden'") + end, "hidden 1"},
      {lengths, "<rect style='x:1px;y:2px;width:3px;height:4px;rx:0px;ry:0px'/>", "rect 1: 1 2 4 6"},
      {lengths, "<circle r='9' style='cx:5px;cy:5px;r:2px'/>", "circle 1: 3 3 7 7"},
      {lengths, "<path id='a' d='M0 0h1v1z' style='d:path(\"M0 0h7v7z\")'/>", "a: 0 0 7 7"},
      {lengths, square("style='width:3'"), "a length without a unit in a style is passed over (width)"},
      {"elements", repeated(257, "<g>") + repeated(257, "</g>"), "elements are nested deeper than 256"},
      {"elements shown, each copy by `use` counted", copies(square(""), 6), "more than 1000000 elements"},
      {"elements shown, each copy by `use` counted", chain_of_uses(500), "nested deeper than 400"},
      {"segments of all outlines, each copy counted; the same of all clip paths, and of all strokes' areas",
       copies("<path d='M0 0" + repeated(300, "h1v1") + "z'/>", 4), "more than 2000000 segments"},
      {"selectors of style sheets", "<style>" + repeated(2001, "a{r:1px}") + "</style>", "more than 2000 selectors"},
      {"coordinates", square("transform='scale(1e60)'"), "a coordinate is beyond 1e60"},
      {"coordinates", square("transform='scale(1e-61)'"), "the drawing is smaller than 1e-60"},
  };
}

}  // namespace

TEST_CASE("what each row of svg_import.md says is so", "[svg][pages]") {
  for (const Case& c : drawing_cases()) {
    CAPTURE(c.row, c.input.substr(0, 200));
    CHECK_THAT(read_drawing(c.input), Catch::Contains(c.expected));
  }
}

TEST_CASE("every row of svg_import.md has a case", "[svg][pages]") {
  std::set<std::string> rows = rows_of("svg_import.md");
  // Limits of two gigabytes and of millions of pieces would take a test too long.
  for (const char* large : {"size of the file, decompressed", "pieces after fitting"}) CHECK(rows.erase(large) == 1);
  CHECK(rows == rows_with_a_case(drawing_cases()));
}
