// tests/boundary/arrangement_contacts_test.cpp: faces whose curves touch, run together, fold or end on each other.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "boundary/painted_faces.h"
#include "pliant/boundary/arrangement.h"
#include "support/sample_boundaries.h"

using namespace pliant;
using namespace pliant::samples;

TEST_CASE("shapes that touch in a corner, on an edge or along a curve give the painted faces", "[boundary]") {
  SECTION("corner to corner") {
    const std::vector<FilledFace> faces{filled("one", {rectangle(2, {0, 0}, {1, 1}), rectangle(2, {1, 1}, {2, 2})})};
    const Arrangement a = arrange(faces);
    check_arranged(faces, a);
    CHECK(a.boundary.vertices == std::vector<Point>{{1, 1}});
  }
  SECTION("a corner on an edge") {
    const std::vector<FilledFace> faces{filled("floor", {rectangle(2, {0, -1}, {3, 0})}),
                                        filled("top", {polygon(2, {{1, 0}, {2, 1}, {0, 1}})})};
    const Arrangement a = arrange(faces);
    check_arranged(faces, a);
    CHECK(a.boundary.vertices == std::vector<Point>{{1, 0}});
  }
  SECTION("circles from outside") {
    const double gap = GENERATE(-1, 1) * GENERATE(1, 2, 5) * std::pow(10.0, GENERATE(range(-16, -6)));
    CAPTURE(gap);
    const double most = circle(2, {}, 1).evaluate(1.5).x;
    const std::vector<FilledFace> faces{filled("left", {circle(2, {}, 1)}),
                                        filled("right", {circle(2, {2 * most + gap, 0}, 1)})};
    check_arranged(faces, arrange(faces));
  }
  SECTION("a circle from inside") {
    const double gap = GENERATE(-1, 0, 1) * GENERATE(1, 2, 5) * std::pow(10.0, GENERATE(range(-16, -6)));
    CAPTURE(gap);
    const std::vector<FilledFace> faces{filled("big", {circle(2, {}, 2, 4)}),
                                        filled("small", {circle(2, {1 + gap, 0}, 1, 4)})};
    check_arranged(faces, arrange(faces));
  }
}

TEST_CASE("two curves that cross close to their common end are cut where they cross", "[boundary]") {
  // y = x^2 - slope x crosses y = 0 at x = slope, and what lies between them there has an area of slope^3 / 6.
  const double slope = GENERATE(1, 3) * std::pow(10.0, GENERATE(range(-11, -2)));
  CAPTURE(slope);
  const std::vector<FilledFace> faces{
      filled("horn", {bezier({{0, 0}, {0.5, 0}, {1, 0}}), bezier({{1, 0}, {1, 0.5}, {1, 1 - slope}}),
                      bezier({{1, 1 - slope}, {0.5, -slope / 2}, {0, 0}})})};
  const Arrangement a = arrange(faces);
  check_arranged(faces, a);
  CHECK(std::fabs(area_of(a.boundary, 0) - (1.0 / 3 - slope / 2)) < 1e-10 + slope * slope * slope / 3);
}

TEST_CASE("a tip, where a curve turns within next to no length, becomes a corner", "[boundary]") {
  const double width = std::pow(10.0, GENERATE(range(-8, -1)));
  CAPTURE(width);
  const std::vector<FilledFace> faces{
      filled("hair", {bezier({{0, 0}, {2, 0}, {0, width}}), bezier({{0, width}, {0, width / 2}, {0, 0}})})};
  const Arrangement a = arrange(faces);
  check_arranged(faces, a);
  CHECK(std::fabs(area_of(a.boundary, 0) - faces[0].curves[0].area()) <
        1e-8);                                               // both sides move by the width of the tip
  if (width < 1e-5) CHECK(a.boundary.vertices.size() == 3);  // two, and the one at the tip
  if (width > 1e-3) CHECK(a.boundary.vertices.size() == 2);
}

TEST_CASE("a point where a cubic stops becomes a corner", "[boundary]") {
  const std::vector<FilledFace> faces{
      filled("cusp", {bezier({{0, 0}, {1, 1}, {0, 1}, {1, 0}}), bezier({{1, 0}, {0.7, 0}, {0.3, 0}, {0, 0}})})};
  const Arrangement a = arrange(faces);
  check_arranged(faces, a);
  CHECK(area_of(a.boundary, 0) == Approx(std::fabs(faces[0].curves[0].area())).epsilon(1e-9));
}

TEST_CASE("control points of small whole numbers, with coincidences everywhere, give the painted faces",
          "[boundary][property]") {
  const int degree = GENERATE(1, 2, 3);
  int refused = 0;
  for (int run = 0; run < 100; ++run) {
    std::mt19937 random(static_cast<unsigned>(1000 * degree + run));
    std::uniform_int_distribution<int> coordinate(0, 4), count(3, 7);
    std::vector<FilledFace> faces;
    for (int n = 0; n < 3; ++n) {
      std::vector<Point> points;
      for (int i = count(random); i > 0; --i)
        points.push_back({static_cast<double>(coordinate(random)), static_cast<double>(coordinate(random))});
      faces.push_back(filled("s" + std::to_string(n), {closed_spline(degree, points)},
                             n % 2 == 0 ? FillRule::evenodd : FillRule::nonzero));
    }
    const Arrangement a = arrange(faces);
    CAPTURE(degree, run, first_text(a.faults));
    // Cubic splines with folded control polygons stop in cusps. Where other curves end or pass there, not every
    // arrangement can be told.
    if (degree == 3 && (!a.faults.empty() || !same(resolve(a.boundary).boundary, a.boundary))) {
      ++refused;
      continue;
    }
    check_arranged(faces, a, 100);
  }
  CHECK(refused <= 5);
}
