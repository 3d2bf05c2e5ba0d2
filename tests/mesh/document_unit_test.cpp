// tests/mesh/document_unit_test.cpp: documents of extreme size are scaled to near 1 and back exactly, or are refused.
#include "pliant/mesh/documents/document_unit.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "pliant/boundary/fault.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

MeshData scaled(MeshData data, int exponent) {
  const double factor = std::ldexp(1.0, exponent);
  for (Point& p : data.points) p *= factor;
  for (Point& p : data.boundary.vertices) p *= factor;
  for (Curve& curve : data.boundary.curves) {
    curve.removal_error *= factor;
    for (int i = 0; i < static_cast<int>(curve.spline.points().size()); ++i)
      curve.spline.set_point(i, factor * curve.spline.points()[static_cast<std::size_t>(i)]);
  }
  return data;
}

}  // namespace

TEST_CASE("a mesh comes back from normalisation bit for bit", "[mesh][unit]") {
  MeshData data = samples::three_disks(3);
  data.boundary.curves[0].removal_error = 1e-5;
  for (const int exponent : {-505, -300, -70, 70, 300, 505}) {
    CAPTURE(exponent);
    const MeshData original = scaled(data, exponent);
    MeshData normalised = original;
    normalize_unit(normalised);
    CHECK(normalised.boundary.unit != 1);
    Box box;
    for (const Point& p : normalised.points) box.extend(p);
    CHECK(box.size() >= 1);
    CHECK(box.size() < 4);
    restore_unit(normalised);
    CHECK(normalised.boundary.unit == 1);
    CHECK(normalised.points == original.points);
    for (std::size_t c = 0; c < original.boundary.curves.size(); ++c) {
      CHECK(normalised.boundary.curves[c].spline.points() == original.boundary.curves[c].spline.points());
      CHECK(normalised.boundary.curves[c].spline.knots() == original.boundary.curves[c].spline.knots());
      CHECK(normalised.boundary.curves[c].removal_error == original.boundary.curves[c].removal_error);
    }
  }
}

TEST_CASE("a power of two changes nothing of a normalised mesh", "[mesh][unit]") {
  MeshData small = scaled(samples::disk(2), -400), large = scaled(samples::disk(2), 500);
  normalize_unit(small);
  normalize_unit(large);
  CHECK(small.points == large.points);
  CHECK(small.boundary.curves[0].spline.points() == large.boundary.curves[0].spline.points());
}

TEST_CASE("sizes that need no help are left alone", "[mesh][unit]") {
  for (const int exponent : {-55, 0, 55}) {
    MeshData data = scaled(samples::disk(2), exponent);
    const std::vector<Point> points = data.points;
    normalize_unit(data);
    CHECK(data.boundary.unit == 1);
    CHECK(data.points == points);
  }
}

TEST_CASE("sizes out of range are refused, with the range", "[mesh][unit]") {
  for (const int exponent : {-600, 600, 1022}) {
    MeshData data = scaled(samples::disk(2), exponent);
    CHECK_THROWS_WITH(normalize_unit(data), Catch::Contains("2^-510") && Catch::Contains("2^510"));
    CHECK_THROWS_AS(require_document_size(data), InputError);
  }
  BoundaryComplex boundary;
  boundary.vertices = {{-1.7e308, 0}, {1.7e308, 0}};
  CHECK_THROWS_AS(normalize_unit(boundary), InputError);
}

TEST_CASE("a coordinate that would lose digits beside the size is refused, with its place", "[mesh][unit]") {
  BoundaryComplex boundary;
  boundary.vertices = {{0, 0}, {0x1p400, 1e-200}};
  try {
    normalize_unit(boundary);
    FAIL("not refused");
  } catch (const InputError& error) {
    CHECK(error.pointer() == "/vertices/3");
  }
  boundary.vertices[1].y = 1e-150;
  CHECK_NOTHROW(normalize_unit(boundary));
}

TEST_CASE("a result that leaves the doubles is no result", "[mesh][unit]") {
  MeshData data = scaled(samples::disk(2), 500);
  normalize_unit(data);
  data.points[0].x = 0x1p600;
  CHECK_THROWS_AS(restore_unit(data), std::domain_error);
}

TEST_CASE("a report's lengths and places are brought back, its counts are not", "[mesh][unit]") {
  PassReport report;
  report.add("triangles", 12);
  report.add_length("largest_error", 0.5);
  report.refuse("too far", Point{1, -2});
  restore_unit(report, 0x1p300);
  CHECK(report.values[0].second == 12);
  CHECK(report.values[1].second == 0x1p299);
  CHECK(report.refused_at[0].place == Point{0x1p300, -0x1p301});
}
