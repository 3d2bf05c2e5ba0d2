// tests/ops/operations_test.cpp: laws of the operations: what each keeps, and what its inverse gives back.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "ops/random_operations.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/locate.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/flip_edge.h"
#include "pliant/ops/insert_point.h"
#include "pliant/ops/remove_point.h"
#include "support/sample_meshes.h"

using namespace pliant;

TEST_CASE("inserting a point changes neither geometry nor fields", "[ops]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  CAPTURE(degree);
  Mesh mesh = carried_disk(degree);
  const Mesh before = mesh;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0.05, 1);
  for (int k = 0; k < 20; ++k) {
    Barycentric xi{uniform(random), uniform(random), uniform(random)};
    const double sum = xi[0] + xi[1] + xi[2];
    for (double& x : xi) x /= sum;
    REQUIRE(insert_point(mesh, static_cast<TriangleId>(random() % 20), xi).outcome == Outcome::done);
  }
  REQUIRE(check_mesh(mesh).empty());
  CHECK(difference_of_functions(before, mesh, 400) < 1e-12);
  CHECK(area_of(mesh) == Approx(area_of(before)).epsilon(1e-14));
}

TEST_CASE("splitting any edge changes neither geometry nor fields nor the curves", "[ops]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  CAPTURE(degree);
  Mesh mesh = carried_disk(degree);
  const Mesh before = mesh;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0.2, 0.8);
  int on_curve = 0;
  for (int k = 0; k < 60; ++k) {
    const auto h = static_cast<HalfEdgeId>(random() % static_cast<unsigned>(3 * mesh.triangle_slots()));
    on_curve += mesh.is_constrained(h);
    REQUIRE(split_edge(mesh, h, uniform(random)).outcome == Outcome::done);
  }
  REQUIRE(on_curve > 2);
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.place << ": " << fault.text);
  CHECK(find_invalid(mesh).empty());
  CHECK(difference_of_functions(before, mesh, 400) < 1e-12);
  CHECK(mesh.spline(0).area() == Approx(before.spline(0).area()).epsilon(1e-14));
}

TEST_CASE("removing an inserted vertex gives back geometry and field", "[ops]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  CAPTURE(degree);
  Mesh mesh = carried_disk(degree);
  const Mesh before = mesh;
  std::mt19937_64 random(5);
  for (TriangleId t = 0; t < 12; ++t) {
    const InsertResult inserted = insert_point(mesh, t, {0.25, 0.45, 0.3});
    REQUIRE(inserted.outcome == Outcome::done);
    CHECK(remove_inner_vertex(mesh, inserted.vertex) == Outcome::done);
  }
  mesh.compact();
  for (const HalfEdgeId h : HalfEdgeRange(12)) {
    if (!mesh.is_alive(triangle_of(h))) continue;
    const bool on_curve = mesh.is_constrained(h);
    const InsertResult inserted = split_edge(mesh, h, 0.375);
    REQUIRE(inserted.outcome == Outcome::done);
    if (on_curve)
      CHECK(remove_curve_vertex(mesh, inserted.vertex, {1e-10}).outcome == Outcome::done);
    else
      CHECK(remove_inner_vertex(mesh, inserted.vertex) == Outcome::done);
  }
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.place << ": " << fault.text);
  CHECK(mesh.triangle_count() == before.triangle_count());
  CHECK(difference_of_functions(before, mesh, 400) < 1e-10);
}

TEST_CASE("flips keep the region, linear functions and integrals", "[ops]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  CAPTURE(degree);
  Mesh mesh = carried_disk(degree);
  const Mesh before = mesh;
  std::mt19937_64 random(3);
  int flips = 0;
  for (int k = 0; k < 300; ++k) {
    const auto h = static_cast<HalfEdgeId>(random() % static_cast<unsigned>(3 * mesh.triangle_slots()));
    const MeshData data = mesh.to_data();
    const Outcome outcome = flip_edge(mesh, h);
    flips += outcome == Outcome::done;
    if (outcome != Outcome::done && k % 10 == 0) CHECK(same_document(data, mesh.to_data()));
  }
  CHECK(flips > 30);
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.place << ": " << fault.text);
  CHECK(find_invalid(mesh).empty());
  CHECK(area_of(mesh) == Approx(area_of(before)).epsilon(1e-13));
  CHECK(linear_error(mesh) < 1e-12);
  CHECK(integral_of(mesh, 1, 0) == Approx(integral_of(before, 1, 0)).margin(1e-12));
  CHECK(integral_of(mesh, 1, 1) == Approx(integral_of(before, 1, 1)).margin(1e-12));
}

TEST_CASE("random sequences of operations keep every invariant", "[ops][property]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const bool by_face = GENERATE(false, true);
  CAPTURE(degree, by_face);
  Mesh mesh = carried_disk(degree, by_face);
  const double integral = integral_of(mesh, 1, 0);
  const double area = area_of(mesh);
  RandomOperations operations(mesh, 17);
  for (int block = 0; block < 12; ++block) {
    CAPTURE(block);
    operations.run(60);
    for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.invariant << " " << fault.place << ": " << fault.text);
    REQUIRE(find_invalid(mesh).empty());
    CHECK(linear_error(mesh) < 1e-11);
    CHECK(area_of(mesh) == Approx(area).epsilon(1e-12));
    CHECK(integral_of(mesh, 1, 0) == Approx(integral).margin(1e-11));
    const MeshData data = mesh.to_data();
    mesh.compact();
    CHECK(same_document(data, mesh.to_data()));
  }
  CHECK(operations.done > 150);
}

TEST_CASE("knot removals within a tolerance keep every invariant and linear functions", "[ops][property]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const bool keep_area = GENERATE(false, true);
  CAPTURE(degree, keep_area);
  Mesh mesh(carried_disk(degree, false, 24));
  const double area = area_of(mesh);
  int removed = 0;
  double error = 0;
  for (PointId v = 0; v < mesh.point_slots(); ++v) {
    Star star;
    if (!mesh.is_vertex(v)) continue;
    find_star(mesh, v, star);
    if (star.is_closed) continue;
    const CurveRemoval removal = remove_curve_vertex(mesh, v, {0.2, 0.05, keep_area});
    if (removal.outcome != Outcome::done) continue;
    ++removed;
    error += removal.error;
    for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.invariant << " " << fault.place << ": " << fault.text);
    REQUIRE(find_invalid(mesh).empty());
  }
  CHECK(removed > 3);
  CHECK(mesh.boundary().curves[0].removal_error == Approx(error));
  CHECK(linear_error(mesh) < 1e-11);
  if (keep_area) CHECK(mesh.spline(0).area() == Approx(area).epsilon(1e-12));
}

TEST_CASE("every point of the domain is found, and no other", "[mesh]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  Mesh mesh = carried_disk(degree);
  RandomOperations(mesh, 23).run(100);
  mesh.compact();
  Locator locator(mesh);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1.2, 1.2);
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  for (int k = 0; k < 500; ++k) {
    const auto t = static_cast<TriangleId>(random() % static_cast<unsigned>(mesh.triangle_slots()));
    Barycentric xi{std::abs(uniform(random)), std::abs(uniform(random)), std::abs(uniform(random))};
    const double sum = xi[0] + xi[1] + xi[2];
    for (double& x : xi) x /= sum;
    const Point p = point_at(mesh, t, xi);
    const auto found =
        locator.find(p, static_cast<TriangleId>(random() % static_cast<unsigned>(mesh.triangle_slots())));
    REQUIRE(found);
    CHECK(distance(point_at(mesh, found->triangle, found->xi), p) < 1e-11);
    const Point far{uniform(random), uniform(random)};
    if (length(far) > 1.0001) CHECK(!locator.find(far));
  }
}
