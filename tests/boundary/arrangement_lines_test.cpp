// tests/boundary/arrangement_lines_test.cpp: lines that cut faces, and areas that clip them.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "pliant/boundary/arrangement.h"
#include "pliant/boundary/check_boundary.h"
#include "support/sample_boundaries.h"

using namespace pliant;

namespace {

BSpline polygon(std::vector<Point> points) {
  std::vector<double> knots;
  for (std::size_t i = 0; i <= points.size(); ++i) knots.push_back(static_cast<double>(i));
  return BSpline(1, true, std::move(knots), std::move(points));
}
BSpline square(double x, double y, double side) {
  return polygon({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}
double area_of(const BoundaryComplex& boundary, const std::string& name) {
  const int face = find_face(boundary, name);
  double sum = 0;
  for (const Curve& curve : boundary.curves)
    sum += (curve.left == face ? curve.spline.area() : 0) - (curve.right == face ? curve.spline.area() : 0);
  return sum;
}
/// How many curves of that name have the same face on both sides.
long slits(const Arrangement& a, const std::string& name) {
  return std::count_if(a.boundary.curves.begin(), a.boundary.curves.end(),
                       [&](const Curve& c) { return c.name == name && c.left == c.right; });
}
Arrangement arranged(const PaintedLayers& layers) {
  Arrangement a = arrange_layers(layers);
  for (const Fault& fault : a.faults) UNSCOPED_INFO(fault.text);
  CHECK(a.faults.empty());
  return a;
}
DrawnLine line(std::vector<Point> points, int above = 1) { return {"line", samples::bezier(std::move(points)), above}; }

}  // namespace

TEST_CASE("a line is cut where it crosses borders, lines and itself, and left out where no face is", "[arrangement]") {
  const FilledFace face{"face", {square(0, 0, 4)}};
  SECTION("inside a face it stays one curve") {
    const Arrangement a = arranged({{face}, {}, {line({{1, 1}, {3, 1}})}});
    CHECK(slits(a, "line") == 1);
    CHECK(a.bare_lines == 0);
    CHECK(area_of(a.boundary, "face") == 16);
  }
  SECTION("across a border") {
    const Arrangement a = arranged({{face}, {}, {line({{-2, 2}, {6, 2}})}});
    CHECK(slits(a, "line") == 1);
    CHECK(a.bare_lines == 2);
    CHECK(a.intersections == 2);
  }
  SECTION("between two faces, outside of the second's cover") {
    const FilledFace above{"above", {square(1, 1, 1)}};
    CHECK(slits(arranged({{face, above}, {}, {line({{0.5, 1.5}, {3, 1.5}})}}), "line") == 2);
    CHECK(slits(arranged({{face, above}, {}, {line({{0.5, 1.5}, {3, 1.5}}, 2)}}), "line") == 3);
  }
  SECTION("a cross, a T and a loop") {
    CHECK(slits(arranged({{face}, {}, {line({{1, 1}, {3, 3}}), line({{1, 3}, {3, 1}})}}), "line") == 4);
    CHECK(slits(arranged({{face}, {}, {line({{1, 1}, {3, 1}}), line({{2, 1}, {2, 3}})}}), "line") == 3);
    CHECK(slits(arranged({{face}, {}, {line({{1, 1}, {6, 3}, {-2, 3}, {3, 1}})}}), "line") == 3);
  }
  SECTION("a closed line divides no face") {
    const Arrangement a = arranged({{face}, {}, {{"line", square(1, 1, 2), 1}}});
    REQUIRE(slits(a, "line") == 1);
    CHECK(a.boundary.faces.size() == 1);
    CHECK(area_of(a.boundary, "face") == 16);
  }
  SECTION("tangent to a border, and to a line") {
    CHECK(slits(arranged({{face}, {}, {line({{1, 1}, {2, -1}, {3, 1}})}}), "line") == 2);
    CHECK(slits(arranged({{face}, {}, {line({{1, 1}, {2, 3}, {3, 1}}), line({{1, 2}, {3, 2}})}}), "line") == 4);
  }
  SECTION("over each other along a stretch (two curves), over themselves, and along a border") {
    CHECK(slits(arranged({{face}, {}, {line({{1, 1}, {3, 1}}), line({{2, 1}, {3.5, 1}})}}), "line") == 2);
    CHECK(slits(arranged({{face}, {}, {line({{1, 1}, {3, 1}}), line({{3, 1}, {1, 1}})}}), "line") == 1);
    const Arrangement a = arranged({{face}, {}, {line({{1, 0}, {2, 0}}), line({{2, 0}, {2, 1}})}});
    CHECK(slits(a, "line") == 1);
    CHECK(a.bare_lines == 0);
  }
  SECTION("lines alone give nothing") {
    CHECK(arrange_layers(PaintedLayers{{}, {}, {line({{1, 1}, {3, 1}}, 0)}}).bare_lines == 1);
  }
}

TEST_CASE("clip areas cut faces and lines: unions of parts, each with its rule and its own clips", "[arrangement]") {
  FilledFace face{"face", {square(0, 0, 4)}};
  face.clips = {0};
  const FilledFace left{"left", {square(-1, -1, 3)}}, right{"right", {square(3, 3, 3)}};
  SECTION("a union") {
    const Arrangement a = arranged({{face}, {{{left, right}}}});
    CHECK(area_of(a.boundary, "face") == Approx(5));
  }
  SECTION("no part shows nothing") {
    CHECK(arrange_layers(PaintedLayers{{face}, {ClipArea{}}}).boundary.faces.empty());
  }
  SECTION("what lies above and is clipped away shows what lies below") {
    const FilledFace ground{"ground", {square(0, 0, 4)}};
    const Arrangement a = arranged({{ground, face}, {{{left, right}}}});
    CHECK(area_of(a.boundary, "face") == Approx(5));
    CHECK(area_of(a.boundary, "ground") == Approx(11));
  }
  SECTION("both areas, and an area that is clipped itself") {
    face.clips = {0, 1};
    const FilledFace band{"band", {square(1, -9, 18)}};
    CHECK(area_of(arranged({{face}, {{{left}}, {{band}}}}).boundary, "face") == Approx(2));
    face.clips = {1};
    CHECK(area_of(arranged({{face}, {{{left}}, {{band}, {0}}}}).boundary, "face") == Approx(2));
    FilledFace part = band;
    part.clips = {0};
    CHECK(area_of(arranged({{face}, {{{left}}, {{part, right}}}}).boundary, "face") == Approx(3));
  }
  SECTION("the rule of a part") {
    FilledFace twice{"twice", {square(0, 0, 4), square(1, 1, 2)}, FillRule::evenodd};
    CHECK(area_of(arranged({{face}, {{{twice}}}}).boundary, "face") == Approx(12));
    twice.rule = FillRule::nonzero;
    CHECK(area_of(arranged({{face}, {{{twice}}}}).boundary, "face") == Approx(16));
  }
  SECTION("lines") {
    face.clips = {};
    DrawnLine drawn = line({{0.5, 1}, {3.5, 1}});
    drawn.clips = {0};
    const Arrangement a = arranged({{face}, {{{left}}}, {drawn}});
    REQUIRE(slits(a, "line") == 1);
    CHECK(a.boundary.curves.back().spline.points().back().x == Approx(2));
  }
}
