// tests/boundary/arrangement_test.cpp: areas, pieces and faults of faces made from curves that cross, touch or overlap.
#include "pliant/boundary/arrangement.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/boundary/check_boundary.h"
#include "pliant/boundary/curve_intersections.h"
#include "pliant/boundary/curve_points.h"
#include "support/sample_boundaries.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

/// A closed polygon as a curve of any degree.
BSpline polygon(int degree, std::vector<Point> points) {
  std::rotate(points.begin(), points.begin() + 1, points.end());  // degree 1 begins in its second knot
  BSpline spline = closed_spline(1, std::move(points));
  while (spline.degree() < degree) spline = spline.elevated();
  return spline;
}
BSpline rectangle(int degree, const Point& low, const Point& high) {
  return polygon(degree, {low, {high.x, low.y}, high, {low.x, high.y}});
}

FilledFace filled(std::string name, std::vector<BSpline> curves, FillRule rule = FillRule::nonzero) {
  return {std::move(name), std::move(curves), rule, {}};
}

/// How often a curve winds around p, by the crossings of a ray; p on no curve.
int winding(const BSpline& spline, const Point& p) {
  int turns = 0;
  std::vector<Point> bezier(static_cast<std::size_t>(spline.degree()) + 1), part(bezier.size());
  const auto breaks = spline.breaks();
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
    spline.extract(breaks[s], bezier);
    std::vector<double> cuts = monotone_cuts(bezier, 1e-12);
    cuts.push_back(1);
    double from = 0;
    Point start = bezier.front();
    for (const double to : cuts) {
      const Point end = to == 1 ? bezier.back() : bezier_point(bezier, to);
      if ((start.y > p.y) != (end.y > p.y)) {
        double low = from, high = to;
        for (int i = 0; i < 60; ++i) {
          const double middle = low + (high - low) / 2;
          ((bezier_point(bezier, middle).y > p.y) == (start.y > p.y) ? low : high) = middle;
        }
        if (bezier_point(bezier, low).x > p.x) turns += end.y > p.y ? 1 : -1;
      }
      from = to;
      start = end;
    }
  }
  return turns;
}

/// The input face that a painter leaves visible at p.
int painted(const std::vector<FilledFace>& faces, const Point& p) {
  int owner = outside;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    int turns = 0;
    for (const BSpline& spline : faces[f].curves) turns += winding(spline, p);
    if (faces[f].rule == FillRule::nonzero ? turns != 0 : turns % 2 != 0) owner = static_cast<int>(f);
  }
  return owner;
}

/// The input face whose region of the arrangement holds p; checks that no two do.
int found_at(const Arrangement& a, const Point& p) {
  std::vector<int> turns(a.boundary.faces.size(), 0);
  for (const Curve& curve : a.boundary.curves) {
    const int w = winding(curve.spline, p);
    if (curve.left != outside) turns[static_cast<std::size_t>(curve.left)] += w;
    if (curve.right != outside) turns[static_cast<std::size_t>(curve.right)] -= w;
  }
  int owner = outside;
  for (std::size_t f = 0; f < turns.size(); ++f) {
    if (turns[f] == 0) continue;
    CHECK(turns[f] == 1);
    CHECK(owner == outside);
    owner = a.sources[f];
  }
  return owner;
}

double area_of(const BoundaryComplex& boundary, int face) {
  double area = 0;
  for (const Curve& curve : boundary.curves)
    area += ((curve.left == face) - (curve.right == face)) * curve.spline.area();
  return area;
}

std::string first_text(const std::vector<Fault>& faults) {
  return faults.empty() ? "" : faults.front().place + ": " + faults.front().text;
}

bool same(const BoundaryComplex& a, const BoundaryComplex& b) {
  const auto same_curve = [](const Curve& x, const Curve& y) {
    return x.name == y.name && x.start == y.start && x.end == y.end && x.left == y.left && x.right == y.right &&
           x.spline.knots() == y.spline.knots() && x.spline.points() == y.spline.points() &&
           x.spline.closed() == y.spline.closed();
  };
  return a.vertices == b.vertices && a.faces.size() == b.faces.size() &&
         std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(), same_curve);
}

/// Points that lie on no curve, with the painter's and the arrangement's answer.
void check_membership(const std::vector<FilledFace>& faces, const Arrangement& a, int count, unsigned seed) {
  Box box;
  for (const FilledFace& face : faces)
    for (const BSpline& spline : face.curves)
      for (const Point& p : spline.points()) box.extend(p);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(box.low.x, box.high.x), y(box.low.y, box.high.y);
  int differ = 0;
  for (int i = 0; i < count; ++i) {
    const Point p{x(random), y(random)};
    differ += painted(faces, p) != found_at(a, p);
  }
  CHECK(differ == 0);
}

void check_arranged(const std::vector<FilledFace>& faces, const Arrangement& a, int count = 300, unsigned seed = 1) {
  REQUIRE(first_text(a.faults) == "");
  REQUIRE(first_text(check_boundary(a.boundary)) == "");
  CHECK(first_text(check_boundary_geometry(a.boundary)) == "");
  check_membership(faces, a, count, seed);
  const Arrangement again = resolve(a.boundary);
  CHECK(first_text(again.faults) == "");
  CHECK(same(again.boundary, a.boundary));
}

}  // namespace

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

TEST_CASE("what is painted over, twice or within comes out once", "[boundary]") {
  const BSpline big = circle(2, {}, 2), small = circle(2, {0.1, 0}, 0.5);
  SECTION("the same shape twice belongs to the last") {
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
  SECTION("the same shape once each way is nothing") {
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
  CHECK(a.boundary.vertices.size() == 25 - 4);  // a corner of the map is no vertex
  CHECK(a.slivers == 0);
}

TEST_CASE("shapes that touch in a corner or along a curve", "[boundary]") {
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

TEST_CASE("random rotated rectangles: every point has the painter's face", "[boundary][property]") {
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

TEST_CASE("random splines that cross themselves and each other", "[boundary][property]") {
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

TEST_CASE("curves of sizes whose products are no numbers are refused", "[boundary]") {
  for (const double size : {1e-101, 1e101}) {
    const Arrangement a = arrange(std::vector<FilledFace>{
        filled("bow", {bezier({{0, 0}, {size, 0}, {size, size}}), bezier({{size, size}, {0, 0}})})});
    CHECK_THAT(first_text(a.faults), Catch::Contains("the curves' size is not between 1e-100 and 1e100"));
  }
}

TEST_CASE("sides that cross next to their tip part there", "[boundary]") {
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

TEST_CASE("what turns in no room becomes a corner", "[boundary]") {
  const double width = std::pow(10.0, GENERATE(range(-8, -1)));
  CAPTURE(width);
  const std::vector<FilledFace> faces{
      filled("hair", {bezier({{0, 0}, {2, 0}, {0, width}}), bezier({{0, width}, {0, width / 2}, {0, 0}})})};
  const Arrangement a = arrange(faces);
  check_arranged(faces, a);
  CHECK(std::fabs(area_of(a.boundary, 0) - faces[0].curves[0].area()) < 1e-8);  // both sides move by the tip's width
  if (width < 1e-5) CHECK(a.boundary.vertices.size() == 3);                     // two, and that at the tip
  if (width > 1e-3) CHECK(a.boundary.vertices.size() == 2);
}

TEST_CASE("where a cubic stops there is a corner", "[boundary]") {
  const std::vector<FilledFace> faces{
      filled("cusp", {bezier({{0, 0}, {1, 1}, {0, 1}, {1, 0}}), bezier({{1, 0}, {0.7, 0}, {0.3, 0}, {0, 0}})})};
  const Arrangement a = arrange(faces);
  check_arranged(faces, a);
  CHECK(area_of(a.boundary, 0) == Approx(std::fabs(faces[0].curves[0].area())).epsilon(1e-9));
}

TEST_CASE("small whole numbers as control points: coincidences everywhere", "[boundary][property]") {
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
    // Cubic splines over folded control polygons stop in cusps; where others end or pass there, not all can be told.
    if (degree == 3 && (!a.faults.empty() || !same(resolve(a.boundary).boundary, a.boundary))) {
      ++refused;
      continue;
    }
    check_arranged(faces, a, 100);
  }
  CHECK(refused <= 5);
}
