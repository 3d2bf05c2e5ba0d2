// tests/boundary/check_boundary_test.cpp: structural faults of a boundary document are found, each with its place.
#include "pliant/boundary/check_boundary.h"

#include <catch2/catch.hpp>

#include "support/sample_boundaries.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

bool names(const std::vector<Fault>& faults, const std::string& place, const std::string& words) {
  for (const Fault& fault : faults)
    if (fault.place == place && fault.text.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("the sample boundaries have no structural fault", "[boundary]") {
  const int degree = GENERATE(1, 2, 3, 4);
  for (const BoundaryComplex& b : {one_cell(degree), biconcave_cell(degree), three_cells(degree), annulus(degree),
                                   interface(degree), square(), divided_square(), gear(), glyph(), crescent(0)})
    CHECK(check_boundary(b).empty());
}

TEST_CASE("indices out of range are named with their place", "[boundary]") {
  BoundaryComplex b = square();
  b.curves[1].start = 9;
  CHECK(names(check_boundary(b), "/curves/1/start", "no vertex 9"));
  b = square();
  b.curves[2].left = 4;
  CHECK(names(check_boundary(b), "/curves/2/left", "no face 4"));
  b = square();
  b.cusps = {7};
  CHECK(names(check_boundary(b), "/cusps/0", "no vertex 7"));
}

TEST_CASE("an open curve ends in its vertices bit for bit", "[boundary]") {
  BoundaryComplex b = square();
  b.vertices[2].x += 1e-15;
  const auto faults = check_boundary(b);
  CHECK(names(faults, "/curves/1/end", "should end in vertex 2, but that is at"));
  CHECK(names(faults, "/curves/2/start", "should end in vertex 2, but that is at"));
  b = square();
  b.curves[0].end = no_vertex;
  CHECK(names(check_boundary(b), "/curves/0/end", "needs a vertex"));
}

TEST_CASE("a closed curve has no ends", "[boundary]") {
  BoundaryComplex b = one_cell(2);
  b.vertices.push_back({0, 0});
  b.curves[0].start = 0;
  CHECK(names(check_boundary(b), "/curves/0/start", "it has no start"));
}

TEST_CASE("faces need a name of their own and a curve", "[boundary]") {
  BoundaryComplex b = interface(2);
  b.faces[1].name = "plasma";
  CHECK(names(check_boundary(b), "/faces/1/name", "face 0's already"));
  b = one_cell(2);
  b.faces.push_back({"nowhere", {}});
  CHECK(names(check_boundary(b), "/faces/1", "no curve bounds"));
  b.faces[1].name.clear();
  CHECK(names(check_boundary(b), "/faces/1/name", "needs a name"));
}

TEST_CASE("a curve with no face on either side is a fault", "[boundary]") {
  BoundaryComplex b = one_cell(2);
  b.curves.push_back(closed_curve("stray", circle(2, {5, 5}, 1), outside));
  CHECK(names(check_boundary(b), "/curves/1/left", "no face on either side"));
}

TEST_CASE("loops that do not close are found at the vertices where they stop", "[boundary]") {
  BoundaryComplex b = square();
  b.curves.pop_back();
  const auto faults = check_boundary(b);
  CHECK(names(faults, "/vertices/0", "starts at vertex 0"));
  CHECK(names(faults, "/vertices/6", "ends at vertex 3"));
  CHECK(names(faults, "/vertices/6", "curve 'side 2' (2) ends there, at parameter 1, face 'square' on its left"));
  CHECK(names(faults, "/vertices/6", "starts at vertex 0 (0, 0), 1 away"));
}

TEST_CASE("numbers that are not finite are found", "[boundary]") {
  BoundaryComplex b = square();
  b.vertices[3].y = std::nan("");
  CHECK(names(check_boundary(b), "/vertices/6", "not finite"));
  b = one_cell(2);
  b.curves[0].removal_error = -1;
  CHECK(names(check_boundary(b), "/curves/0/removal_error", "finite length"));
  b = one_cell(3);
  b.curves[0].spline.set_point(2, {HUGE_VAL, 0});
  CHECK(names(check_boundary(b), "/curves/0", "points/2"));
}

TEST_CASE("two vertices at one point are named where a loop does not close between them", "[boundary]") {
  BoundaryComplex b = square();
  b.vertices.push_back(b.vertices[2]);
  b.curves[2].start = 4;
  CHECK(names(check_boundary(b), "/vertices/4", "starts at vertex 4 (1, 1), the same point"));
}
