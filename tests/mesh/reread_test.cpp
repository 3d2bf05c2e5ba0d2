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

TEST_CASE("a mesh reread is settled until something in it changes, and rolled-back changes are none", "[mesh]") {
  Mesh mesh(samples::three_disks(2));
  Field field;
  field.name = "u";
  field.values.assign(static_cast<std::size_t>(mesh.point_slots()), 1);
  mesh.set_field(field);
  CHECK_FALSE(mesh.is_settled());
  reread(mesh);
  REQUIRE(mesh.is_settled());
  const MeshData before = mesh.to_data();
  {
    Transaction transaction(mesh);
    const TriangleId t = mesh.add_triangle(0);
    mesh.set_net_point(t, 0, mesh.add_point());
    mesh.set_point(0, {5, 5});
    mesh.put_component(0, 0, 0, 0, 7);
    Transaction inner(mesh);
    mesh.free_triangle(0);
    inner.commit();
    CHECK_FALSE(mesh.is_settled());
    CHECK_FALSE(mesh.is_compact());
  }
  CHECK(mesh.is_settled());
  CHECK(mesh.is_compact());
  CHECK(mesh.to_data().points == before.points);
  CHECK(mesh.to_data().triangles == before.triangles);

  SECTION("an inner roll-back does not hide what the outer transaction changed") {
    Transaction transaction(mesh);
    mesh.set_point(0, {5, 5});
    {
      Transaction inner(mesh);
      mesh.put_component(0, 0, 0, 0, 7);
    }
    transaction.commit();
    CHECK_FALSE(mesh.is_settled());
    CHECK(mesh.is_compact());
    const double size = mesh.size();
    mesh.compact();
    CHECK(mesh.size() > size);
    CHECK_FALSE(mesh.is_settled());
    reread(mesh);
    CHECK(mesh.is_settled());
  }
  SECTION("a value") {
    mesh.put_component(0, 0, 0, 0, HUGE_VAL);
    CHECK_THROWS_AS(reread(mesh), std::domain_error);
    CHECK_THROWS_AS(reread(mesh), std::domain_error);
  }
  SECTION("a place that was measured") {
    mesh.set_point(0, {0, std::nan("")});
    mesh.compact();
    CHECK_THROWS_AS(reread(mesh), std::domain_error);
  }
  SECTION("a curve") {
    mesh.set_removal_error(0, std::nan(""));
    CHECK_THROWS_AS(reread(mesh), std::domain_error);
  }
  SECTION("a vertex of the boundary, or a whole curve") {
    mesh.set_boundary_motion(0, mesh.spline(0));
    CHECK_FALSE(mesh.is_settled());
    reread(mesh);
    CHECK(mesh.is_settled());
  }
  SECTION("time") {
    mesh.time = HUGE_VAL;
    CHECK_THROWS_AS(reread(mesh), std::domain_error);
  }
}
