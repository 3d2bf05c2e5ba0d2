// tests/boundary/arrangement_test.cpp: areas and pieces of faces whose curves cross, lie over each other or are apart.
#include "pliant/boundary/arrangement.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "boundary/painted_faces.h"
#include "support/sample_boundaries.h"

using namespace pliant;
using namespace pliant::samples;

TEST_CASE("overlapping squares give the areas of inclusion and exclusion", "[boundary]") {
  const int degree = GENERATE(1, 2, 3, 5);
  const std::vector<FilledFace> faces{filled("below", {rectangle(degree, {0, 0}, {2, 2})}),
                                      filled("above", {rectangle(degree, {1, 1}, {4, 3})})};
  const Arrangement a = arrange(faces);
  check_arranged(faces, a);
  CHECK(a.intersections == 2);
  CHECK(a.regions == 3);
  CHECK(area_of(a.boundary, 0) == Approx(3).epsilon(1e-14));
  CHECK(area_of(a.boundary, 1) == Approx(6).epsilon(1e-14));
  CHECK(a.boundary.vertices.size() == 2);
  for (const Point& p : a.boundary.vertices) CHECK(distance(p, p.x > 1.5 ? Point{2, 1} : Point{1, 2}) < 1e-15);
  CHECK(a.boundary.curves.size() == 3);
}

TEST_CASE("overlapping splines keep their parts exactly", "[boundary]") {
  const int degree = GENERATE(2, 3, 5);
  const std::vector<FilledFace> faces{filled("left", {circle(degree, {0, 0}, 1, 9)}),
                                      filled("right", {circle(degree, {0.7, 0.1}, 1, 8)})};
  const Arrangement a = arrange(faces);
  check_arranged(faces, a, 2000);
  REQUIRE(a.boundary.curves.size() == 3);
  CHECK(a.boundary.vertices.size() == 2);
  const double both = area_of(a.boundary, 0) + area_of(a.boundary, 1);
  const Arrangement other = arrange(std::vector<FilledFace>{faces[1], faces[0]});
  CHECK(both == Approx(area_of(other.boundary, 0) + area_of(other.boundary, 1)).epsilon(1e-14));
  CHECK(area_of(a.boundary, 1) == Approx(faces[1].curves[0].area()).epsilon(1e-14));
  // Interior knots stay simple: every curve is as smooth as it was.
  for (const Curve& curve : a.boundary.curves)
    for (const double t : curve.spline.breaks())
      CHECK(curve.spline.multiplicity(t) ==
            (t == curve.spline.first_parameter() || t == curve.spline.last_parameter() ? degree + 1 : 1));
}

TEST_CASE("a pentagram is full by the nonzero rule and hollow by the evenodd rule", "[boundary]") {
  std::vector<Point> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 4 * std::numbers::pi * i / 5;
    star.push_back({std::cos(angle), std::sin(angle)});
  }
  // The pentagon inside has the circumradius r; the tips are five triangles on its sides.
  const double r = std::cos(0.4 * std::numbers::pi) / std::cos(0.2 * std::numbers::pi);
  const double pentagon = 2.5 * r * r * std::sin(0.4 * std::numbers::pi);
  const double tips = 5 * r * std::sin(0.2 * std::numbers::pi) * (1 - r * std::cos(0.2 * std::numbers::pi));
  const std::vector<FilledFace> full{filled("star", {polygon(2, star)})};
  const std::vector<FilledFace> hollow{filled("star", {polygon(2, star)}, FillRule::evenodd)};
  const Arrangement a = arrange(full), b = arrange(hollow);
  check_arranged(full, a);
  check_arranged(hollow, b);
  CHECK(area_of(a.boundary, 0) == Approx(pentagon + tips).epsilon(1e-13));
  CHECK(area_of(b.boundary, 0) == Approx(tips).epsilon(1e-13));
  CHECK(a.regions == 6);
  CHECK(a.intersections == 5);
}

TEST_CASE("shapes that hide, contain or repeat each other give disjoint faces", "[boundary]") {
  const BSpline big = circle(2, {}, 2), small = circle(2, {0.1, 0}, 0.5);
  SECTION("the same shape twice belongs to the last face") {
    const std::vector<FilledFace> faces{filled("first", {big}), filled("second", {big})};
    const Arrangement a = arrange(faces);
    check_arranged(faces, a);
    CHECK(a.sources == std::vector<int>{1});
    REQUIRE(a.boundary.curves.size() == 1);
    CHECK(a.boundary.curves[0].spline.points() == big.points());
  }
  SECTION("a shape within another makes a hole in it") {
    const std::vector<FilledFace> faces{filled("sea", {big}), filled("island", {small})};
    const Arrangement a = arrange(faces);
    check_arranged(faces, a);
    CHECK(area_of(a.boundary, 0) == Approx(big.area() - small.area()).epsilon(1e-14));
  }
  SECTION("a shape over a smaller one hides it") {
    const std::vector<FilledFace> faces{filled("island", {small}), filled("sea", {big})};
    const Arrangement a = arrange(faces);
    check_arranged(faces, a);
    CHECK(a.sources == std::vector<int>{1});
    CHECK(a.boundary.curves.size() == 1);
  }
  SECTION("the same shape once in each direction gives nothing") {
    std::vector<Point> back = big.points();
    std::reverse(back.begin(), back.end());
    const Arrangement a = arrange(std::vector<FilledFace>{filled("none", {big, closed_spline(2, back)})});
    CHECK(a.faults.empty());
    CHECK(a.boundary.faces.empty());
    CHECK(a.boundary.curves.empty());
  }
  SECTION("nothing gives nothing") { CHECK(arrange({}).boundary.curves.empty()); }
}

TEST_CASE("squares that share edges and corners make a map", "[boundary]") {
  const int degree = GENERATE(1, 2, 3);
  std::vector<FilledFace> faces;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      faces.push_back(filled("cell " + std::to_string(4 * i + j),
                             {rectangle(degree, {0.1 * i, 0.1 * j}, {0.1 * (i + 1), 0.1 * (j + 1)})}));
  const Arrangement a = arrange(faces);
  check_arranged(faces, a);
  CHECK(a.regions == 16);
  CHECK(a.pieces == 40);
  CHECK(a.boundary.vertices.size() == 25 - 4);  // the four corners of the map are no vertices
  CHECK(a.slivers == 0);
}

TEST_CASE("in random rotated rectangles every point has the face that was painted last", "[boundary][property]") {
  const unsigned seed = GENERATE(range(0u, 6u));
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<FilledFace> faces;
  for (int n = 0; n < 25; ++n) {
    const double angle = 7 * unit(random), width = 0.05 + 0.3 * unit(random), height = 0.05 + 0.3 * unit(random);
    const Point c{unit(random), unit(random)};
    const Vector u{std::cos(angle) * width, std::sin(angle) * width}, v = height / width * perpendicular(u);
    faces.push_back(filled("r" + std::to_string(n),
                           {polygon(1 + static_cast<int>(seed % 3), {c - u - v, c + u - v, c + u + v, c - u + v})},
                           n % 3 == 0 ? FillRule::evenodd : FillRule::nonzero));
  }
  check_arranged(faces, arrange(faces), 2000, seed);
}

TEST_CASE("in random splines, crossing themselves and each other, every point has the face that was painted last",
          "[boundary][property]") {
  const int degree = GENERATE(1, 2, 3, 5);
  const unsigned seed = GENERATE(range(0u, 4u));
  CAPTURE(degree, seed);
  std::mt19937 random(100 * static_cast<unsigned>(degree) + seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<FilledFace> faces;
  for (int n = 0; n < 5; ++n) {
    std::vector<Point> points;
    for (int i = 0; i < 9; ++i) points.push_back({unit(random), unit(random)});
    faces.push_back(filled("s" + std::to_string(n), {closed_spline(degree, points)},
                           n % 2 == 0 ? FillRule::evenodd : FillRule::nonzero));
  }
  check_arranged(faces, arrange(faces), 1000, seed);
}

TEST_CASE("a boundary without crossings stays as it is", "[boundary]") {
  const int degree = GENERATE(1, 2, 3);
  for (const BoundaryComplex& b :
       {one_cell(degree), biconcave_cell(degree), three_cells(degree), annulus(degree), interface(degree), square(),
        divided_square(), gear(), glyph(), crescent(0.3), crescent(1e-6), crescent(0)}) {
    const Arrangement a = resolve(b);
    CHECK(first_text(a.faults) == "");
    CHECK(same(a.boundary, b));
  }
}

TEST_CASE("loops that do not close are named", "[boundary]") {
  const Arrangement a = arrange(std::vector<FilledFace>{filled("open", {bezier({{0, 0}, {1, 0}, {1, 1}})})});
  CHECK_THAT(first_text(a.faults), Catch::Contains("'open' do not close at (0, 0)"));
}

TEST_CASE("curves so large or small that products of lengths overflow or vanish are refused", "[boundary]") {
  for (const double size : {1e-101, 1e101}) {
    const Arrangement a = arrange(std::vector<FilledFace>{
        filled("bow", {bezier({{0, 0}, {size, 0}, {size, size}}), bezier({{size, size}, {0, 0}})})});
    CHECK_THAT(first_text(a.faults), Catch::Contains("the curves' size is not between 1e-100 and 1e100"));
  }
}
