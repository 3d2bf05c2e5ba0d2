// tests/boundary/check_boundary_sides_test.cpp: curves that name a wrong face beside them are found.
#include <catch2/catch.hpp>
#include <random>

#include "pliant/boundary/check_boundary.h"
#include "support/sample_boundaries.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

std::vector<Fault> sides(const BoundaryComplex& b) {
  REQUIRE(check_boundary(b).empty());
  REQUIRE(check_boundary_geometry(b).empty());
  return check_boundary_sides(b);
}

std::string first_side_text(const BoundaryComplex& b) {
  const auto faults = sides(b);
  return faults.empty() ? "" : faults.front().place + ": " + faults.front().text;
}

/// Circles in circles, `depth` deep, each a face of its own, or a hole; one in three runs clockwise.
void nest(BoundaryComplex& b, std::mt19937& random, const Point& center, double radius, int around, int depth) {
  const int count = depth == 0 ? 0 : std::uniform_int_distribution<int>(1, 3)(random);
  for (int i = 0; i < count; ++i) {
    const Point at = center + 0.4 * radius * Point{std::cos(2.1 * i + depth), std::sin(2.1 * i + depth)};
    int inside = outside;
    if (around == outside || random() % 4 > 0) {
      inside = static_cast<int>(b.faces.size());
      b.faces.push_back({"face " + std::to_string(inside), {}});
    }
    BSpline spline = circle(static_cast<int>(1 + random() % 4), at, 0.25 * radius, 16);
    const bool clockwise = random() % 3 == 0;
    if (clockwise) {
      std::vector<Point> points = spline.points();
      std::reverse(points.begin(), points.end());
      spline = closed_spline(spline.degree(), std::move(points));
    }
    b.curves.push_back(closed_curve("", spline, clockwise ? around : inside, clockwise ? inside : around));
    nest(b, random, at, 0.25 * radius, inside, depth - 1);
  }
}

}  // namespace

TEST_CASE("the sample boundaries name the faces that lie beside their curves", "[boundary]") {
  const int degree = GENERATE(1, 2, 3, 4);
  for (const BoundaryComplex& b :
       {one_cell(degree), biconcave_cell(degree), three_cells(degree), annulus(degree), interface(degree), square(),
        divided_square(), gear(), glyph(), crescent(0.3), crescent(1e-6), crescent(0)})
    CHECK(first_side_text(b) == "");
}

TEST_CASE("among circles in circles, the one that names wrong faces is reported", "[boundary][property]") {
  const auto seed = GENERATE(range(0u, 40u));
  CAPTURE(seed);
  std::mt19937 random(seed);
  BoundaryComplex b;
  nest(b, random, {0.3, -7}, 10, outside, 4);
  CHECK(first_side_text(b) == "");

  const std::size_t c = random() % b.curves.size();
  std::swap(b.curves[c].left, b.curves[c].right);
  const auto faults = sides(b);
  REQUIRE(faults.size() == 1);
  CHECK(faults.front().place.starts_with("/curves/" + std::to_string(c) + "/"));
  CHECK_THAT(faults.front().text, Catch::Contains("lies there: exchange left and right"));
}

TEST_CASE("a face on the wrong side of its only curve is reported", "[boundary]") {
  BoundaryComplex b = one_cell(2);
  std::swap(b.curves[0].left, b.curves[0].right);
  CHECK_THAT(first_side_text(b), Catch::Contains("/curves/0/") && Catch::Contains("exchange left and right"));
  b = annulus(2, 0.5);
  std::swap(b.curves[0].spline, b.curves[1].spline);
  CHECK(sides(b).size() == 1);
}

TEST_CASE("a hole that names its face on the inside is reported, though the area of the face stays positive",
          "[boundary]") {
  BoundaryComplex b = square();
  b.curves.push_back(closed_curve("hole", circle(2, {0.5, 0.5}, 0.2), 0, outside));
  CHECK_THAT(first_side_text(b),
             Catch::Contains("curve 'hole' (4) at parameter") &&
                 Catch::Contains("the outside on its right, but face 'square' lies there: exchange"));
}

TEST_CASE("a curve that names the wrong face around it is reported with the right one", "[boundary]") {
  BoundaryComplex b = square();
  b.faces.push_back({"one", {}});
  b.faces.push_back({"two", {}});
  b.curves.push_back(closed_curve("one", circle(2, {0.25, 0.5}, 0.2), 1, 0));
  b.curves.push_back(closed_curve("two", circle(2, {0.75, 0.5}, 0.2), 2, 1));
  CHECK_THAT(first_side_text(b), Catch::Contains("curve 'two' (5)") &&
                                     Catch::Contains("face 'one' on its right, but by all other curves face 'square'"));
  b.curves[5].right = outside;
  CHECK_THAT(first_side_text(b),
             Catch::Contains("names the outside on its right") && Catch::Contains("face 'square' lies"));
}

TEST_CASE("a face on the wrong side of several curves is reported once", "[boundary]") {
  BoundaryComplex b = square();
  for (Curve& curve : b.curves) std::swap(curve.left, curve.right);
  const auto faults = sides(b);
  REQUIRE(faults.size() == 1);
  CHECK(faults.front().place == "/faces/0");
  CHECK_THAT(faults.front().text, Catch::Contains("curve 'side 0' (0), ") && Catch::Contains("of all of them"));
}

TEST_CASE("a curve with one face on both sides is a slit of that face", "[boundary]") {
  BoundaryComplex b = square();
  b.faces.push_back({"other", {}});
  b.curves.push_back(closed_curve("other", circle(2, {2, 2}, 0.2), 1));
  b.vertices.push_back({0.2, 0.3});
  b.vertices.push_back({0.7, 0.6});
  b.curves.push_back(open_curve(b, "slit", 4, 5, {{0.5, 0.2}}, 0, 0));
  CHECK(first_side_text(b) == "");
  b.curves.back().left = b.curves.back().right = 1;
  CHECK_THAT(first_side_text(b), Catch::Contains("'slit'") && Catch::Contains("face 'square' lies there"));
}

TEST_CASE("sides are found in gaps of a billionth, far from the origin", "[boundary]") {
  BoundaryComplex b = with_faces({"inner", "outer"});
  b.curves.push_back(closed_curve("inner", circle(2, {1e3, 1e3}, 1, 16), 0, outside));
  b.curves.push_back(closed_curve("ring", circle(2, {1e3, 1e3}, 1 + 1e-9, 16), outside, outside));
  b.curves.push_back(closed_curve("outer", circle(2, {1e3, 1e3}, 2, 16), 1, outside));
  b.curves[1].right = 1;
  CHECK(first_side_text(b) == "");
  std::swap(b.curves[1].left, b.curves[1].right);
  CHECK_THAT(first_side_text(b), Catch::Contains("'ring'"));
}
