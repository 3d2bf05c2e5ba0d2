// tests/formats/svg_reader_bad_test.cpp: files that are no SVG, hostile drawings, and drawings that are no boundary.
#include <catch2/catch.hpp>
#include <chrono>
#include <random>

#include "formats/svg_import/svg_reader.h"
#include "pliant/boundary/check_boundary.h"
#include "support/refusals.h"

using namespace pliant;
using samples::check_none, samples::Outcomes;

namespace {

std::string in_svg(const std::string& content) {
  return "<svg xmlns='http://www.w3.org/2000/svg'>\n" + content + "</svg>";
}

/// What is said of a bad drawing: its place and what is wrong; "none" if it is read.
std::string complaint(const std::string& document) {
  try {
    read_svg(document);
  } catch (const InputError& e) {
    return e.pointer().empty() ? e.what() : e.pointer() + ": " + e.what();
  }
  return "none";
}
std::string of_path(const std::string& d) { return complaint(in_svg("<g><path id='a' d='" + d + "'/></g>")); }

}  // namespace

TEST_CASE("a fault of path data is refused with the element's place, the offset and what was expected", "[svg]") {
  const auto check = [](const std::string& d, const std::string& expected) {
    CAPTURE(d);
    CHECK_THAT(of_path(d), Catch::StartsWith("line 2, column 4: path 'a': d, offset " + expected));
  };
  check("L1 1", "0: expected the path to start with M or m, found 'L1 1'");
  check("M1", "2: expected a coordinate, found the end");
  check("M1 1 2", "6: expected a coordinate, found the end");
  check("M1 1 X", "5: expected a command, one of MLHVCSQTAZ or mlhvcsqtaz, found 'X'");
  check("M1 1,", "5: expected a number behind the comma, found the end");
  check("M1 1L,2 2", "5: expected a coordinate, found ',2 2'");
  check("M1 1L2,,2", "7: expected a coordinate, found ',2'");
  check("M1 1 C 1 1 2 2 3", "16: expected a coordinate");
  check("M1 1 A 1 1 0 2 0 5 5", "13: expected the flag 0 or 1, found '2 0 5 5'");
  check("M1 1 A 1 1 0 1 0 5", "18: expected a coordinate, found the end");
  check("M1 1 z 3 3", "7: expected a command");
  check("M1 1 h1e999", "6: expected a coordinate that is finite, found '1e999'");
  check("M1 1 hnan", "6: expected a coordinate, found 'nan'");
  check("M1 1 hinf", "6: expected a coordinate, found 'inf'");
  check("M1 1 h+-1", "6: expected a coordinate, found '+-1'");
  check("M1 1 h0x10 5", "7: expected a command");
}

TEST_CASE("faults of other attributes name the attribute", "[svg]") {
  CHECK_THAT(complaint(in_svg("<rect width='5' height='-5'/>")), Catch::Contains("height is negative: '-5'"));
  CHECK_THAT(complaint(in_svg("<rect width='5' height='5 px'/>")), Catch::Contains("expected one of the units"));
  CHECK_THAT(complaint(in_svg("<rect width='5lh' height='5'/>")),
             Catch::Contains("width, offset 1: expected one of the"));
  CHECK_THAT(complaint(in_svg("<rect width='5%' height='5'/>")), Catch::Contains("neither a viewBox nor"));
  CHECK_THAT(complaint(in_svg("<circle r='x'/>")), Catch::Contains("r, offset 0: expected a length, found 'x'"));
  CHECK_THAT(complaint(in_svg("<polygon points='1 2 3'/>")), Catch::Contains("points, offset 5: expected a second"));
  CHECK_THAT(complaint(in_svg("<g transform='rotate(1 2)'/>")), Catch::Contains("expected 1 or 3 numbers of rotate"));
  CHECK_THAT(complaint(in_svg("<g transform='spin(1)'/>")), Catch::Contains("expected a transform of spin"));
  CHECK_THAT(complaint(in_svg("<g transform='scale(1'/>")), Catch::Contains("expected a number or )"));
  CHECK_THAT(complaint("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 5'/>"),
             Catch::Contains("viewBox, offset"));
  CHECK_THAT(complaint("<svg width='abc'/>"), Catch::Contains("svg: width, offset 0: expected a length, found 'abc'"));
  CHECK_THAT(
      complaint("<svg><svg viewBox='0 0 1 1'><rect width='1' height='1'/></svg></svg>"),
      Catch::Contains("its width and height are parts of the drawing's, which has neither a viewBox nor a size"));
  CHECK_THAT(complaint("<svg><rect width='1' height='1' transform='scale(2)' transform-origin='50% 3'/></svg>"),
             Catch::Contains("transform-origin, offset 0: it is a part of the drawing's size, but the drawing has"));
  CHECK_THAT(complaint(in_svg("<path d='M0 0h1e99v1e99z' transform='scale(1e9)'/>")), Catch::Contains("beyond 1e60"));
}

TEST_CASE("what is no SVG is refused with line and column", "[svg]") {
  CHECK_THAT(complaint(""), Catch::StartsWith("the input is empty"));
  CHECK_THAT(complaint("{}"), Catch::StartsWith("line 1, column 1: no well-formed XML"));
  CHECK_THAT(complaint("<html/>"), Catch::Contains("expected the root element svg of an SVG document, found 'html'"));
  CHECK_THAT(complaint("<svg xmlns='urn:x'/>"), Catch::Contains("expected the root element svg"));
  CHECK_THAT(complaint("<svg><rect></svg>"),
             Catch::StartsWith("line 1, column 14: no well-formed XML: mismatched tag"));
  CHECK_THAT(complaint("<svg><x:rect/></svg>"), Catch::Contains("unbound prefix"));
  CHECK_THAT(complaint(in_svg("")), Catch::StartsWith("nothing is filled"));
  CHECK_THAT(complaint(in_svg("<path d='M0 0L5 5z'/><path fill='none' d='M0 0h1v1z'/>")),
             Catch::StartsWith("nothing is filled: 1 filled shape without an interior, 1 without a fill"));
}

TEST_CASE("entity bombs, external entities and absurd nesting are refused", "[svg]") {
  std::string bomb = "<!DOCTYPE svg [<!ENTITY a 'aaaaaaaaaa'>";
  for (char c = 'b'; c < 'm'; ++c) {
    bomb += std::string("<!ENTITY ") + c + " '";
    for (int i = 0; i < 10; ++i) bomb += std::string("&") + static_cast<char>(c - 1) + ";";
    bomb += "'>";
  }
  CHECK_THAT(complaint(bomb + "]><svg><style>&l;</style></svg>"), Catch::Contains("the entity 'b' refers to others"));
  std::string flat = "<!DOCTYPE svg [<!ENTITY a '" + std::string(1000, 'x') + "'>]><svg><style>";
  for (int i = 0; i < 30000; ++i) flat += "&a;";
  CHECK_THAT(complaint(flat + "</style></svg>"), Catch::Contains("limit on input amplification factor"));
  CHECK_THAT(complaint("<!DOCTYPE svg [<!ENTITY a '" + std::string(5000, 'x') + "'>]><svg/>"),
             Catch::Contains("longer"));
  CHECK_THAT(complaint("<!DOCTYPE svg [<!ENTITY a SYSTEM '/etc/passwd'>]><svg>&a;</svg>"),
             Catch::Contains("is external"));
  CHECK_THAT(complaint("<!DOCTYPE svg [<!ENTITY % a 'b'>]><svg/>"), Catch::Contains("is a parameter entity"));
  std::string deep = "<svg>";
  for (int i = 0; i < 200000; ++i) deep += "<g>";
  CHECK_THAT(complaint(deep), Catch::Contains("elements are nested deeper than 256"));
}

TEST_CASE("use that contains itself, or multiplies without end, is refused", "[svg]") {
  CHECK_THAT(complaint(in_svg("<g id='a'><use href='#a'/></g>")), Catch::Contains("it shows '#a', which contains it"));
  CHECK_THAT(complaint(in_svg("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>")),
             Catch::Contains("which contains it"));
  CHECK_THAT(complaint("<svg id='s'><use href='#s'/></svg>"), Catch::Contains("which contains it"));
  std::string bomb = "<defs><path id='u0' d='M0 0h1v1z'/>";
  for (int k = 1; k < 12; ++k) {
    bomb += "<g id='u" + std::to_string(k) + "'>";
    for (int i = 0; i < 10; ++i) bomb += "<use href='#u" + std::to_string(k - 1) + "'/>";
    bomb += "</g>";
  }
  CHECK_THAT(complaint(in_svg(bomb + "</defs><use href='#u11'/>")), Catch::Contains("more than 1000000 elements"));
  std::string chain;
  for (int k = 0; k < 1000; ++k)
    chain += "<use id='u" + std::to_string(k) + "' href='#u" + std::to_string(k + 1) + "'/>";
  CHECK_THAT(complaint(in_svg(chain + "<rect id='u1000' width='1' height='1'/>")),
             Catch::Contains("nested deeper than"));
  chain.clear();
  for (int k = 0; k < 1000; ++k)
    chain += "<symbol id='s" + std::to_string(k) + "'><use href='#s" + std::to_string(k + 1) + "'/></symbol>";
  CHECK_THAT(complaint(in_svg(chain + "<symbol id='s1000'/><use href='#s0'/>")), Catch::Contains("nested"));
}

TEST_CASE("shapes that cross, touch or lie over each other are refused with both names and the place", "[svg]") {
  const std::string a = "<rect id='a' width='4' height='4'/>\n";
  std::string text = complaint(in_svg(a + "<rect id='b' x='3' y='1' width='4' height='2'/>"));
  CHECK_THAT(text, Catch::StartsWith("shapes cross, touch or lie over each other; import-svg --planar"));
  CHECK_THAT(text, Catch::Contains("'a, line 2'") && Catch::Contains("'b, line 3'") && Catch::Contains("at (4, -"));
  text = complaint(in_svg(a + "<circle id='b' cx='2' cy='2' r='1'/>"));
  CHECK_THAT(text, Catch::Contains("'b' (line 3) lies over 'a' (line 2), at (2, -3)"));
  CHECK_THAT(complaint(in_svg(a + "<rect id='b' x='4' width='4' height='4'/>")),
             Catch::Contains("--planar makes disjoint"));
  CHECK_THAT(complaint(in_svg(a + a)), Catch::Contains("--planar makes disjoint"));
  CHECK_THAT(of_path("M0 0L4 4L4 0L0 4z"), Catch::Contains("'a, line 2' (0) at parameter 2.828") &&
                                               Catch::Contains("at parameter 12.48") && !Catch::Contains("enclose"));
}

TEST_CASE("curves at the limits of what is read end in a boundary or a refusal, soon", "[svg]") {
  const auto curves = [](const std::string& s) {
    return in_svg("<path d='M0 0C3" + s + " 8" + s + " -2" + s + " 9" + s + " 6" + s + " 7" + s + "Q9" + s + " 0 4" +
                  s + " 0A1" + s + " 2" + s + " 30 1 1 2" + s + " -1" + s + "z'/>");
  };
  for (const char* scale : {"", "e50", "e-50", "e58", "e-58"}) CHECK(complaint(curves(scale)) == "none");
  CHECK_THAT(complaint(curves("e99")), Catch::Contains("beyond 1e60"));
  CHECK_THAT(complaint(curves("e-99")), Catch::Contains("is smaller than 1e-60"));
  CHECK_THAT(complaint(curves("e-300")), Catch::Contains("is smaller than 1e-60"));
  CHECK(complaint(in_svg("<path d='M0 0h9v9zM1e-200 -1C1e-200 -2 2e-200 -1 2e-200 -2z'/>")) == "none");
  // A tiny chord of a huge circle, and a huge chord of a tiny one.
  CHECK(complaint(in_svg("<path d='M0 0A1e50 1e50 0 0 1 9 0V9H0z'/>")) == "none");
  CHECK(complaint(in_svg("<path d='M0 0A1e-50 1e-50 0 0 1 9 0V9H0z'/>")) == "none");
  CHECK(complaint(in_svg("<path d='M0 0A5 5 0 1 1 1e-9 0z'/>")) == "none");
}

TEST_CASE("ten megabytes of path data take a second or two", "[svg]") {
  const auto start = std::chrono::steady_clock::now();
  std::string d = "M0 0";
  // A comb: up and down, and back below.
  while (d.size() < 10'000'000) d += "v-5h1v5h1";
  CHECK_THAT(of_path(d + "v9H0z"), Catch::Contains("more than 2000000 segments"));
  std::string smaller = "M0 0";
  for (long i = 0; i < 100'000; ++i) smaller += "v-5h1v5h1";
  CHECK(read_svg(in_svg("<path d='" + smaller + "v9H0z'/>")).boundary.curves.at(0).spline.points().size() == 400'003);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  CHECK(passed.count() < 60);  // 1.3 s as released, and a sanitizer's share
}

TEST_CASE("whatever is done to a drawing, it is a boundary or bad input", "[svg]") {
  const std::string good = R"svg(<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100"><style>.a{fill:none} #b{fill:red}</style>
<defs><g id="g"><path d="M1 1h2v2z"/></g><symbol id="s" viewBox="0 0 5 5"><circle r="2"/></symbol></defs>
<path id="b" fill-rule="evenodd" d="M10 10h60v60h-60z M20 20 q10 -5 20 0 t0 10 L 20 60 z"/>
<use href="#g" x="80" y="80"/><use href="#s" width="5" height="5" x="90" y="5"/>
<rect x="75" y="5" width="10" height="30" rx="3"/><ellipse cx="60" cy="85" rx="20" ry="7" transform="rotate(10 60 85)"/>
<path class="x" d="M85 60C80 50 72 55 74 62S85 80 85 80S95 70 95 62S90 50 85 60z"/>
<path d="M5 90a3 2 20 1 0 5 1zM1 1l2 2 2-2"/><polygon style="fill-rule:nonzero" points="1,20 5,20 5,30"/></svg>)svg";
  REQUIRE(complaint(good) == "none");
  static const std::vector<std::string> words = {"0",   "-1",   "1e9",          "1e-9", "1e99",      "nan", "z", "M",
                                                 "a",   "%",    "none",         "#g",   "#s",        "1 1", "e", "-",
                                                 "<g>", "</g>", "c1 1 1 1 1 1", "t",    "0 0 0 0 0", "."};
  std::mt19937_64 random(7);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  Outcomes outcomes;
  for (int k = 0; k < 20000; ++k) {
    std::string bad = good;
    for (std::size_t times = 1 + below(3); times > 0; --times) {
      const std::size_t at = below(bad.size());
      switch (below(6)) {
        case 0:
          bad[at] = static_cast<char>(random());
          break;
        case 1:
          bad.erase(at, 1 + below(5));
          break;
        case 2:
          bad.insert(at, bad.substr(below(bad.size()), 1 + below(30)));
          break;
        default: {
          const std::size_t digit = bad.find_first_of("0123456789", at);
          if (digit != std::string::npos) bad.replace(digit, 1, words[below(words.size())]);
        }
      }
    }
    outcomes.count([&] {
      const SvgImport import = read_svg(bad, {static_cast<int>(2 + below(2)), 1e-4, k % 8 == 0});
      check_none(check_boundary(import.boundary), bad);
      check_none(check_boundary_geometry(import.boundary), bad);
    });
  }
  CHECK(outcomes.taken > 500);
  CHECK(outcomes.refused > 500);
}
