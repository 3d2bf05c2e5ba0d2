// tests/formats/svg_reader_faces_test.cpp: basic shapes, transforms and fill rules make faces of the right areas.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "formats/drawn_boundary.h"
#include "formats/svg_import/svg_reader.h"

using namespace pliant;
using namespace pliant::samples;

TEST_CASE("basic shapes are what the specification says they are as paths", "[svg]") {
  const auto same = [](const std::string& shape, const std::string& d) {
    CAPTURE(shape);
    const auto a = spans_of(read(svg(shape)).boundary), b = spans_of(read(path(d)).boundary);
    REQUIRE(a.size() == b.size());
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t k = 0; k < a[i].size(); ++k) most = std::max(most, distance(a[i][k], b[i].at(k)));
    CHECK(most < 1e-13);
  };
  same("<rect x='1' y='2' width='3' height='4'/>", "M1 2H4V6H1z");
  same("<rect x='1' y='2' width='10' height='8' rx='2' ry='1'/>",
       "M3 2H9A2 1 0 0 1 11 3V9A2 1 0 0 1 9 10H3A2 1 0 0 1 1 9V3A2 1 0 0 1 3 2z");
  same("<polyline points='0 0,4 0 4-3'/>", "M0 0L4 0L4 -3z");
  CHECK(area(svg("<rect width='10' height='4' rx='99'/>")) ==
        Approx(10 * 4 - (4 - std::numbers::pi) * 5 * 2).epsilon(1e-5));  // rx is half the width, ry half the height
  CHECK(area(svg("<rect width='10' height='10' ry='2'/>")) == Approx(100 - (4 - std::numbers::pi) * 4).epsilon(1e-5));
}

TEST_CASE("transforms apply from the inside out", "[svg]") {
  const auto points = [](const std::string& transform) {
    const SvgImport import =
        read(svg("<g transform='translate(100 200)'><path d='M1 2L5 2L5 9z' transform='" + transform + "'/></g>"));
    std::vector<Point> out = import.boundary.curves.at(0).spline.points();
    std::rotate(out.begin(), out.end() - 1, out.end());
    return out;
  };
  const auto check = [&](const std::string& transform, std::vector<Point> expected) {
    CAPTURE(transform);
    const auto got = points(transform);
    REQUIRE(got.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(got[i].x == Approx(100 + expected[i].x));
      CHECK(got[i].y == Approx(-(200 + expected[i].y)));
    }
  };
  check("", {{1, 2}, {5, 2}, {5, 9}});
  check("translate(3)", {{4, 2}, {8, 2}, {8, 9}});
  check("translate(3,-4)", {{4, -2}, {8, -2}, {8, 5}});
  check("scale(2)", {{2, 4}, {10, 4}, {10, 18}});
  check("scale(2 -1)", {{2, -2}, {10, -2}, {10, -9}});
  check("rotate(90)", {{-2, 1}, {-2, 5}, {-9, 5}});
  check("rotate(90 1 2)", {{1, 2}, {1, 6}, {-6, 6}});
  check("matrix(1 2 3 4 5 6)", {{1 + 6 + 5, 2 + 8 + 6}, {5 + 6 + 5, 10 + 8 + 6}, {5 + 27 + 5, 10 + 36 + 6}});
  check("skewX(45)", {{3, 2}, {7, 2}, {14, 9}});
  check("skewY(45)", {{1, 3}, {5, 7}, {5, 14}});
  check("translate(1,0) , scale(2)\n rotate(180)", {{1 - 2, -4}, {1 - 10, -4}, {1 - 10, -18}});
}

TEST_CASE("fill rules decide what a hole is", "[svg]") {
  const std::string outer = "M0 0h10v10h-10z", same_way = "M2 2h6v6h-6z", other_way = "M2 2v6h6v-6z";
  const std::string inmost = "M4 4h2v2h-2z";
  const auto filled = [](const std::string& d, const std::string& rule) {
    return area(svg("<path fill-rule='" + rule + "' d='" + d + "'/>"));
  };
  CHECK(filled(outer + other_way, "nonzero") == Approx(64));
  CHECK(filled(outer + same_way, "nonzero") == Approx(100));
  CHECK(filled(outer + same_way, "evenodd") == Approx(64));
  CHECK(filled(outer + other_way, "evenodd") == Approx(64));
  CHECK(filled(inmost + same_way + outer, "evenodd") == Approx(68));
  CHECK(filled(inmost + other_way + outer, "nonzero") == Approx(68));
  CHECK(read(path(outer + same_way)).no_border == 1);
}

TEST_CASE("a shape in another one's hole has a face of its own", "[svg]") {
  const SvgImport import =
      read(svg("<path id='ring' fill-rule='evenodd' d='M0 0h10v10h-10zM1 1h8v8h-8z'/><circle id='island' cx='5' cy='5' "
               "r='2'/><path id='inner ring' d='M2 2h6v6h-6zM2.5 2.5v5h5v-5z'/>"));
  CHECK(import.boundary.faces.size() == 3);
  CHECK(face_area(import.boundary, "ring") == Approx(36));
  CHECK(face_area(import.boundary, "inner ring") == Approx(11));
  CHECK(face_area(import.boundary, "island") == Approx(4 * std::numbers::pi).epsilon(1e-5));
}

TEST_CASE("nesting is right for tips, verticals and equal abscissas above each other", "[svg]") {
  std::string d;
  // Diamonds and squares, each around the next, all with corners at x = 0 and alternating directions.
  for (int k = 12; k > 0; --k) {
    const std::string r = std::to_string(3 * k);
    d += "M0 -" + r + "L" + r + " 0L0 " + r + "L-" + r + " 0z";
    // A triangle below, with its tip at x = 0.
    d += "M0 " + std::to_string(3 * k + 1) + "l0.5 0.25l0 -0.125z";
  }
  // From the outside in, what is filled alternates; a triangle lies just outside of its diamond.
  double expected = 0;
  for (int k = 12; k > 0; --k) expected += (k % 2 == 0 ? 1 : -1) * (2.0 * 9 * k * k + 0.03125);
  CHECK(area(svg("<path fill-rule='evenodd' d='" + d + "'/>")) == Approx(expected).epsilon(1e-12));
}

TEST_CASE("a planar drawing's faces are what is seen of its shapes", "[svg]") {
  const std::string drawing = svg(
      "<rect id='a' width='10' height='10'/><rect id='covered' x='8' y='4' width='1' height='1'/><circle id='b' "
      "cx='10' "
      "cy='5' r='4'/><rect id='c' x='2' y='2' width='3' height='3'/><rect id='d' y='10' width='10' height='3'/><path "
      "id='e' fill-rule='evenodd' d='M20 0L24 4V0L20 4z'/><path id='star' fill-rule='nonzero' d='M30 "
      "0h6v6h-4v-4h2v2h-4z'/>");
  const int degree = GENERATE(2, 3);
  const SvgImport import = read(drawing, {degree, 1e-8, true});
  constexpr double pi = std::numbers::pi;
  CHECK(import.boundary.faces.size() == 6);
  CHECK(import.covered == 1);
  CHECK(face_area(import.boundary, "a") == Approx(100 - 8 * pi - 9).epsilon(1e-6));
  CHECK(face_area(import.boundary, "b") == Approx(16 * pi).epsilon(1e-6));
  CHECK(face_area(import.boundary, "c") == Approx(9));
  CHECK(face_area(import.boundary, "d") == Approx(30));
  CHECK(face_area(import.boundary, "e") == Approx(8));
  CHECK(find_face(import.boundary, "covered") == outside);
  // Apart, shapes give the same faces with and without.
  const std::string apart =
      svg("<path id='ring' fill-rule='evenodd' d='M0 0h10v10h-10zM1 1h8v8h-8z'/><circle id='o' "
          "cx='5' cy='5' r='2'/>");
  const SvgImport plain = read(apart), planar = read(apart, {2, 1e-6, true});
  CHECK(face_area(plain.boundary, "ring") == Approx(face_area(planar.boundary, "ring")).epsilon(1e-14));
  CHECK(face_area(plain.boundary, "o") == Approx(face_area(planar.boundary, "o")).epsilon(1e-14));
  CHECK(planar.intersections == 0);
}

TEST_CASE("a border that two shapes share is one, however each has cut it", "[svg]") {
  // The same cubic whole, and back in two parts whose numbers have five digits.
  const std::string drawing =
      svg("<path id='one' d='M0 0C30 40 71 47 103 0V-90H0z'/><path id='other' d='M103 0C91.16 17.39 78.0879 27.3874 "
          "64.79676 31.05591C42.1659 37.3023 18.9 25.2 0 0V90H103z'/>");
  const SvgImport import = read(drawing, {2, 1e-6, true});
  REQUIRE(import.boundary.faces.size() == 2);
  CHECK(import.boundary.curves.size() == 3);
  CHECK(import.boundary.vertices.size() == 2);
  CHECK(import.snapped == Approx(1e-6 * import.size));
  CHECK(face_area(import.boundary, "one") + face_area(import.boundary, "other") == Approx(180 * 103).epsilon(1e-12));
  const SvgImport exact = read(drawing, {2, 1e-10, true});  // the digits that are missing are told
  CHECK(face_area(exact.boundary, "one") == Approx(face_area(import.boundary, "one")).epsilon(1e-6));
  CHECK(exact.boundary.curves.size() > 3);
}
