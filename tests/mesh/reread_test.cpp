// tests/mesh/reread_test.cpp: a mesh reread is the one that a reader of its document gets.
#include "pliant/mesh/documents/reread.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "pliant/boundary/fault.h"
#include "pliant/mesh/documents/document_unit.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

/// Multiplies all positions by a power of two, as a motion would.
void grow(Mesh& mesh, int exponent) {
  const double factor = std::ldexp(1.0, exponent);
  std::vector<Point> points;
  for (PointId p = 0; p < mesh.point_slots(); ++p) points.push_back(factor * mesh.point(p));
  mesh.set_points(std::move(points));
  for (CurveId c = 0; c < static_cast<CurveId>(mesh.boundary().curves.size()); ++c) {
    BSpline spline = mesh.spline(c);
    for (int i = 0; i < static_cast<int>(spline.points().size()); ++i)
      spline.set_point(i, factor * spline.points()[static_cast<std::size_t>(i)]);
    mesh.set_boundary_motion(c, spline);
  }
}

}  // namespace

TEST_CASE("a mesh reread has the size and the unit that a reader gives it", "[mesh]") {
  const int exponent = GENERATE(0, 1, 50, 61, 100, 300, -100);
  CAPTURE(exponent);
  Mesh mesh(samples::three_disks(2));
  grow(mesh, exponent);
  MeshData document = mesh.to_data();
  normalize_unit(document);
  const Mesh read(document);
  reread(mesh);
  CHECK(mesh.boundary().unit == read.boundary().unit);
  CHECK((mesh.boundary().unit == 1) == (std::abs(exponent) < 60));
  CHECK(mesh.size() == read.size());
  CHECK(mesh.tolerance() == read.tolerance());
  CHECK(mesh.to_data().points == document.points);

  // A second change of size goes on from there: what counts is the size in the document.
  grow(mesh, -exponent);
  reread(mesh);
  CHECK(mesh.boundary().unit == 1);
  CHECK(mesh.to_data().points == samples::three_disks(2).points);
}

TEST_CASE("what no document can hold is refused", "[mesh]") {
  Mesh mesh(samples::disk(2));
  SECTION("a value that is not finite") {
    Field field;
    field.name = "u";
    field.values.assign(static_cast<std::size_t>(mesh.point_slots()), 0);
    field.values.back() = HUGE_VAL;
    mesh.set_field(field);
    CHECK_THROWS_AS(reread(mesh), std::domain_error);
  }
  SECTION("a place that is not finite") {
    mesh.set_point(0, {0, std::nan("")});
    CHECK_THROWS_AS(reread(mesh), std::domain_error);
  }
  SECTION("a time that is not finite") {
    mesh.time = HUGE_VAL;
    CHECK_THROWS_AS(reread(mesh), std::domain_error);
  }
  SECTION("a size out of range") {
    grow(mesh, 600);
    CHECK_THROWS_AS(reread(mesh), InputError);
  }
}
