// tests/formats/svg_reader_test.cpp: outlines become splines, exactly or within the tolerance.
#include "formats/svg_import/svg_reader.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "formats/drawn_boundary.h"

using namespace pliant;
using namespace pliant::samples;

TEST_CASE("lines and quadratic curves keep their control points bit for bit, with y upwards", "[svg]") {
  const SvgImport import = read(path("M.1.7L3.3 .7Q5.7 1.1 3.1 4.9Q 2.3 6.1 .1 4.3z"));
  REQUIRE(import.boundary.curves.size() == 1);
  CHECK(import.boundary.faces[0].name == "path 1");
  CHECK(import.fitted == 0);
  CHECK(import.error == 0);
  CHECK(has_span(import.boundary, {{3.3, -.7}, {5.7, -1.1}, {3.1, -4.9}}));
  CHECK(has_span(import.boundary, {{3.1, -4.9}, {2.3, -6.1}, {.1, -4.3}}));
  CHECK(has_span(import.boundary, {{.1, -.7}, {(.1 + 3.3) / 2, -.7}, {3.3, -.7}}));
}

TEST_CASE("a polygon is one closed curve of degree 1", "[svg]") {
  const SvgImport import = read(svg("<polygon id='p' points='0,0 4,0 4,3'/>"));
  const Curve& curve = import.boundary.curves.at(0);
  CHECK(curve.spline.degree() == 1);
  CHECK(curve.spline.closed());
  CHECK(import.boundary.vertices.empty());
  CHECK(face_area(import.boundary, "p") == Approx(6));
  CHECK(curve.name == "p");
}

TEST_CASE("a smooth join of quadratic curves is a simple knot, a corner one of multiplicity 2", "[svg]") {
  // The second curve goes on smoothly with legs in the ratio 1:2, then comes a corner.
  const SvgImport import = read(path("M0 0Q1 1 2 1Q4 1 5 -2z"));
  const BSpline& spline = import.boundary.curves.at(0).spline;
  CHECK_FALSE(spline.closed());
  CHECK(import.boundary.vertices.size() == 1);
  const std::vector<double> breaks = spline.breaks();
  REQUIRE(breaks.size() == 4);
  CHECK(spline.multiplicity(breaks[1]) == 1);
  CHECK(spline.multiplicity(breaks[2]) == 2);
  CHECK((breaks[2] - breaks[1]) / (breaks[1] - breaks[0]) == Approx(2));
  CHECK(import.smooth == 1);
  CHECK(import.corners == 2);
}

TEST_CASE("a loop that is smooth all round is a closed curve with simple knots", "[svg]") {
  const SvgImport import = read(path("M2 0Q2 2 0 2T-2 0T0 -2T2 0z"));
  const BSpline& spline = import.boundary.curves.at(0).spline;
  CHECK(spline.closed());
  CHECK(spline.points().size() == 4);
  CHECK(has_span(import.boundary, {{2, 0}, {2, -2}, {0, -2}}));
  for (const double t : spline.breaks()) CHECK(spline.derivative(t, true) == spline.derivative(t));
}

TEST_CASE("smooth loops of unequal legs lose the knot's ratio in one vertex at most", "[svg]") {
  const SvgImport import = read(path("M0 0C0 -3 5 -3 5 0S3 2 2 2S0 1 0 0z"));
  CHECK(import.boundary.vertices.size() <= 1);
  for (const Curve& curve : import.boundary.curves) {
    const BSpline& spline = curve.spline;
    const std::vector<double> breaks = spline.breaks();
    for (std::size_t i = 1; i + 1 < breaks.size(); ++i) CHECK(spline.multiplicity(breaks[i]) == 1);
  }
}

TEST_CASE("relative commands say the same as absolute ones", "[svg]") {
  const std::string absolute =
      "M 8 4 L 16 4 H 20 V 8 C 24 8 24 12 20 12 S 18 16 20 20 Q 16 24 12 20 T 8 20 A 4 6 30 0 1 4 12 Z";
  const std::string relative = "m8 4 8 0h4v4c4 0 4 4 0 4s-2 4 0 8q-4 4-8 0t-4 0a4 6 30 01-4-8z";
  const auto a = spans_of(read(path(absolute)).boundary), b = spans_of(read(path(relative)).boundary);
  CHECK(a == b);
  CHECK(a.size() > 20);
}

TEST_CASE("numbers need no separators where the grammar tells them apart", "[svg]") {
  const auto expected = spans_of(read(path("M 0.5 -0.5 L 1.5 0.5 L 100 -3 A 25 25 0 0 1 0.5 40.5 Z")).boundary);
  CHECK(spans_of(read(path("M.5-.5 1.5.5 1e2-3A25 25 0 01.5 40.5z")).boundary) == expected);
  CHECK(spans_of(read(path("\n m .5,-5e-1\tl+1,1 98.5-3.5 A 2.5E1,25,0,0,1,.5,40.5 Z\r\n ")).boundary) == expected);
}

TEST_CASE("a subpath may start at the end of a closed one, and open ones are closed by a line", "[svg]") {
  CHECK(area(path("M0 0h2v2h-2zm5 0h3v3h-3z")) == Approx(13));
  CHECK(area(path("M1 1zh2v2h-2z")) == Approx(4));
  CHECK(area(path("M0 0h2v2h-2M5 0h3v3h-3")) == Approx(13));
}

TEST_CASE("circles and ellipses have their area and are round within the tolerance", "[svg]") {
  const int degree = GENERATE(2, 3);
  const double tolerance = GENERATE(1e-3, 1e-6, 1e-9);
  CAPTURE(degree, tolerance);
  constexpr double pi = std::numbers::pi;
  const SvgImport circle = read(svg("<circle id='c' cx='3' cy='-2' r='5'/>"), {degree, tolerance});
  const double allowed = tolerance * circle.size;
  const auto off_circle = [](const Point& p) { return distance(p, {3, 2}) - 5; };
  CHECK(worst(circle.boundary, off_circle) <= circle.error + 1e-14);
  CHECK(circle.error <= allowed);
  CHECK(worst(circle.boundary, off_circle) > circle.error / 3);  // the bound is at most three times the error
  CHECK(std::abs(face_area(circle.boundary, "c") - 25 * pi) <= 2 * pi * 5 * allowed);
  CHECK(circle.boundary.curves.at(0).spline.closed());

  const SvgImport ellipse =
      read(svg("<ellipse id='e' cx='1' cy='1' rx='6' ry='2' transform='rotate(30) skewX(20)'/>"), {degree, tolerance});
  CHECK(face_area(ellipse.boundary, "e") == Approx(12 * pi).epsilon(20 * tolerance));
  CHECK(ellipse.boundary.curves.at(0).spline.closed());
  CHECK(ellipse.error <= tolerance * ellipse.size);
}

TEST_CASE("arcs lie on the ellipse of the specification, whatever their flags", "[svg]") {
  const int large = GENERATE(0, 1), sweep = GENERATE(0, 1);
  const double angle = GENERATE(0.0, 30.0, 90.0, -200.0);
  CAPTURE(large, sweep, angle);
  const double rx = 5, ry = 3;
  const Point from{1, 2}, to{4, 4};
  const SvgImport import = read(
      path("M1 2A5 3 " + std::to_string(angle) + " " + std::to_string(large) + " " + std::to_string(sweep) + " 4 4z"));
  // Appendix F.6.5 of SVG 1.1, letter by letter.
  const double phi = angle * std::numbers::pi / 180, c = std::cos(phi), s = std::sin(phi);
  const double x1 = c * (from.x - to.x) / 2 + s * (from.y - to.y) / 2;
  const double y1 = -s * (from.x - to.x) / 2 + c * (from.y - to.y) / 2;
  const double root =
      std::sqrt((rx * rx * ry * ry - rx * rx * y1 * y1 - ry * ry * x1 * x1) / (rx * rx * y1 * y1 + ry * ry * x1 * x1)) *
      (large == sweep ? -1 : 1);
  const double cx1 = root * rx * y1 / ry, cy1 = -root * ry * x1 / rx;
  const Point center{c * cx1 - s * cy1 + (from.x + to.x) / 2, s * cx1 + c * cy1 + (from.y + to.y) / 2};
  const auto unit = [&](const Point& p) {
    const Vector v = Point{p.x, -p.y} - center;
    return Vector{(c * v.x + s * v.y) / rx, (-s * v.x + c * v.y) / ry};
  };
  const Vector e = unit({from.x, -from.y}), f = unit({to.x, -to.y});
  double turn = std::atan2(cross(e, f), dot(e, f));
  if (sweep == 1 && turn < 0) turn += 2 * std::numbers::pi;
  if (sweep == 0 && turn > 0) turn -= 2 * std::numbers::pi;
  CHECK((std::abs(turn) > std::numbers::pi) == (large == 1));
  const BSpline& spline = import.boundary.curves.at(0).spline;
  // The last span is the line back.
  const std::vector<double> breaks = spline.breaks();
  const double end = breaks[breaks.size() - 2];
  double swept = 0;
  Vector before = unit(spline.evaluate(0));
  for (int i = 1; i <= 1000; ++i) {
    const Vector at = unit(spline.evaluate(end * i / 1000));
    CHECK(std::abs(length(at) - 1) < 1e-6 * import.size);
    swept += std::atan2(cross(before, at), dot(before, at));
    before = at;
  }
  CHECK(swept == Approx(turn).margin(1e-5));
}

TEST_CASE("radii too small for an arc grow, and radii of 0 make a line", "[svg]") {
  CHECK(area(path("M0 0A1 1 0 0 1 10 0z")) == Approx(25 * std::numbers::pi / 2).epsilon(1e-5));
  CHECK(area(path("M0 0A2 1 0 0 1 10 0z")) == Approx(12.5 * std::numbers::pi / 2).epsilon(1e-5));
  // The segment of a circle with a chord of 10 and a radius of 5e5, on either side.
  for (const int sweep : {0, 1})
    CHECK(area(path("M0 0A5e5 5e5 0 0 " + std::to_string(sweep) + " 10 0V-1H0z")) ==
          Approx(10 + (sweep == 0 ? 1 : -1) * 1000.0 / 12 / 5e5).epsilon(1e-12));
  CHECK(area(path("M0 0A0 5 0 0 1 10 0v4h-10z")) == Approx(40));
  CHECK(area(path("M0 0A5 5 0 0 1 0 0h10v4h-10z")) == Approx(40));
}

TEST_CASE("cubics are exact at degree 3 and within the tolerance at degree 2", "[svg]") {
  const std::string d = "M0 0C3 8 -2 9 6 7C 12 5 9 -9 4 -4C1 -2 0 -3 0 0z";
  const SvgImport exact = read(path(d), {3, 1e-6});
  CHECK(exact.fitted == 0);
  CHECK(has_span(exact.boundary, {{0, 0}, {3, -8}, {-2, -9}, {6, -7}}));
  const double tolerance = GENERATE(1e-2, 1e-4, 1e-6, 1e-8);
  CAPTURE(tolerance);
  const SvgImport fitted = read(path(d), {2, tolerance});
  CHECK(fitted.error <= tolerance * fitted.size);
  CHECK(fitted.error > 0);
  CHECK(fitted.boundary.curves.at(0).spline.degree() == 2);
  // Distance to a dense polygon of the exact curve.
  std::vector<Point> polygon;
  const BSpline& truth = exact.boundary.curves.at(0).spline;
  for (int i = 0; i <= 20000; ++i) polygon.push_back(truth.evaluate(truth.period() * i / 20000));
  const auto off = [&](const Point& p) {
    double least = HUGE_VAL;
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
      const Vector leg = polygon[i + 1] - polygon[i];
      const double t = std::clamp(dot(p - polygon[i], leg) / squared_length(leg), 0.0, 1.0);
      least = std::min(least, distance(p, polygon[i] + t * leg));
    }
    return least;
  };
  const BSpline& spline = fitted.boundary.curves.at(0).spline;
  double most = 0;
  for (int i = 0; i <= 300; ++i) most = std::max(most, off(spline.evaluate(spline.period() * i / 300)));
  CHECK(most <= fitted.error + 1e-7);
  CHECK(static_cast<double>(fitted.pieces) < 12 * std::pow(tolerance, -0.25) + 40);
}

TEST_CASE("inflections, cusps and vanishing derivatives of cubics are fitted within the tolerance", "[svg]") {
  const std::string d = GENERATE("M0 0C0 0 5 5 10 0V-5H0z",       // no derivative at the start
                                 "M0 0C5 5 10 0 10 0V-5H0z",      // nor at the end
                                 "M0 0C9 9 3 -9 12 0V-9H0z",      // an inflection
                                 "M0 0C10 8 0 8 10 0V-5H0z",      // a cusp
                                 "M0 0C3 0 7 0 10 0V-5H0z",       // a straight one
                                 "M0 0C12 9 -2 9 10 0.1V-5H0z");  // nearly a cusp: a loop
  const int degree = GENERATE(2, 3);
  CAPTURE(d, degree);
  if (d.find("12 9 -2 9") != std::string::npos) {
    CHECK_THROWS_AS(read_svg(path(d), {degree, 1e-6}), InputError);
    return;
  }
  const SvgImport import = read(path(d), {degree, 1e-6});
  CHECK(import.error <= 1e-6 * import.size);
  CHECK(import.pieces < 120);
}

TEST_CASE("a cusp of the outline is a vertex and listed as such", "[svg]") {
  const SvgImport import = read(path("M0 0Q5 0 5 5Q5 0 10 0Q10 8 5 8Q0 8 0 0z"));
  REQUIRE(import.boundary.cusps.size() == 1);
  CHECK(import.boundary.vertices[static_cast<std::size_t>(import.boundary.cusps[0])] == Point{5, -5});
}
