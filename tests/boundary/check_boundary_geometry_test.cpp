// tests/boundary/check_boundary_geometry_test.cpp: curves that cross or touch are found, with parameters and places.
#include <catch2/catch.hpp>

#include "pliant/boundary/check_boundary.h"
#include "support/sample_boundaries.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

std::string first_text(const BoundaryComplex& b) {
  REQUIRE(check_boundary(b).empty());
  const auto faults = check_boundary_geometry(b);
  return faults.empty() ? "" : faults.front().place + ": " + faults.front().text;
}

}  // namespace

TEST_CASE("the sample boundaries may be meshed", "[boundary]") {
  const int degree = GENERATE(1, 2, 3, 4);
  for (const BoundaryComplex& b :
       {one_cell(degree), biconcave_cell(degree), three_cells(degree), annulus(degree), interface(degree), square(),
        divided_square(), gear(), glyph(), crescent(0.3), crescent(1e-6), crescent(0)})
    CHECK(first_text(b) == "");
}

TEST_CASE("curves that cross are named with parameters and place", "[boundary]") {
  BoundaryComplex b = three_cells(2);
  b.curves[1].spline = circle(2, {-0.5, 0.2}, 0.8);
  CHECK_THAT(first_text(b), Catch::Contains("/curves/0") && Catch::Contains("'membrane 0' (0) at parameter") &&
                                Catch::Contains("crosses curve 'membrane 1' (1) at parameter"));
}

TEST_CASE("a figure of eight meets itself", "[boundary]") {
  BoundaryComplex b = with_faces({"eight"});
  b.curves.push_back(closed_curve("eight", closed_spline(2, {{0, 0}, {2, 0}, {2, 1}, {0, -2}, {-2, -2}, {-2, 1}}), 0));
  b.curves[0].spline =
      closed_spline(3, {{0, 0}, {1, 1}, {2, 1}, {2, -1}, {1, -1}, {-1, 1}, {-2, 1}, {-2, -1}, {-1, -1}});
  CHECK_THAT(first_text(b), Catch::Contains("meets curve 'eight' (0)"));
}

TEST_CASE("a curve that touches another from inside is found", "[boundary]") {
  BoundaryComplex b = with_faces({"square"});
  b.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int i = 0; i < 4; ++i) b.curves.push_back(open_curve(b, "", i, (i + 1) % 4, {}, 0));
  // A quadratic spline through the midpoints of its legs: (0.5, 0) is one of them.
  b.curves.push_back(closed_curve("hole", closed_spline(2, {{0.4, 0}, {0.6, 0}, {0.8, 0.5}, {0.2, 0.5}}), outside, 0));
  CHECK_THAT(first_text(b), Catch::Contains("touches or overlaps curve 'hole' (4)"));
  b.curves.back().spline = closed_spline(2, {{0.4, 1e-8}, {0.6, 1e-8}, {0.8, 0.5}, {0.2, 0.5}});
  CHECK(first_text(b) == "");
}

TEST_CASE("a curve through another's vertex is found, also where its own knot lies there", "[boundary]") {
  BoundaryComplex b = square();
  b.faces.push_back({"other", {}});
  b.curves.push_back(closed_curve("diamond", closed_spline(1, {{1, 1}, {2, 1}, {2, 2}, {1.5, 3}}), 1));
  CHECK_THAT(first_text(b), Catch::Contains("meets curve 'diamond' (4)") && Catch::Contains("at (1, 1)"));
  CHECK(check_boundary_geometry(b).size() == 2);  // at the end of one side, and at the start of the next
}

TEST_CASE("curves that share both their ends may bound a lens, but not coincide", "[boundary]") {
  BoundaryComplex b = with_faces({"lens"});
  b.vertices = {{0, 0}, {1, 0}};
  b.curves.push_back(open_curve(b, "lower", 0, 1, {{0.5, -0.2}}, 0));
  b.curves.push_back(open_curve(b, "upper", 1, 0, {{0.5, 0.2}}, 0));
  CHECK(first_text(b) == "");
  b.curves[1] = open_curve(b, "upper", 1, 0, {{0.5, -0.2}}, 0);
  CHECK(first_text(b) != "");
}

TEST_CASE("a span of no length and a curve that stops are found", "[boundary]") {
  BoundaryComplex b = one_cell(2);
  b.curves[0].spline = closed_spline(1, {{0, 0}, {1, 0}, {1, 0}, {0, 1}});
  CHECK_THAT(first_text(b), Catch::Contains("parameters 2 to 3") && Catch::Contains("it stays at (1, 0)"));
  b = square();
  b.curves[0] = open_curve(b, "stops", 0, 1, {{0, 0}}, 0);
  CHECK_THAT(first_text(b), Catch::Contains("derivative vanishes at (0, 0)"));
}

TEST_CASE("two vertices at one point are found", "[boundary]") {
  BoundaryComplex b = square();
  b.vertices.push_back({1, 1});
  CHECK_THAT(first_text(b), Catch::Contains("vertices 2 and 4 are the same point (1, 1)"));
}

TEST_CASE("a loop of one span may share its vertex with another curve", "[boundary]") {
  BoundaryComplex b = with_faces({"loop", "other"});
  b.vertices = {{0, 0}, {-1, 0}};
  b.curves.push_back(open_curve(b, "loop", 0, 0, {{1, -1}, {1, 1}}, 0));
  b.curves.push_back(open_curve(b, "lower", 1, 0, {{-0.5, -0.5}}, 1));
  b.curves.push_back(open_curve(b, "upper", 0, 1, {{-0.5, 0.5}}, 1));
  CHECK(first_text(b) == "");
  b.curves[0] = open_curve(b, "loop", 0, 0, {{-2, -0.2}, {1, 1}}, 0);
  CHECK_THAT(first_text(b), Catch::Contains("curve 'loop' (0)") && Catch::Contains("crosses curve 'upper' (2)"));
}

TEST_CASE("a vertex that no curve ends in may lie anywhere but on a curve", "[boundary]") {
  BoundaryComplex b = square();
  b.vertices.push_back({0.5, 1e-8});
  CHECK(first_text(b) == "");
  b.vertices.back().y = 0;
  CHECK_THAT(first_text(b),
             Catch::Contains("vertex 4 (0.5, 0), no curve's end, lies on curve 'side 0' (0) at parameter"));
}

TEST_CASE("curves that coincide are reported once for each span", "[boundary]") {
  BoundaryComplex b = one_cell(2);
  b.faces.push_back({"twin", {}});
  b.curves.push_back(closed_curve("twin", b.curves[0].spline, 1));
  const auto faults = check_boundary_geometry(b);
  CHECK(faults.size() == 8);
  for (const Fault& fault : faults) CHECK(fault.invariant == "contact");
}
