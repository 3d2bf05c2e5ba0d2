// tests/mesh/locate_test.cpp: points are found in their elements, from any hint and always in the same one.
#include "pliant/mesh/locate.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "mesh/curved_samples.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/predicates.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/ops/insert_point.h"
#include "pliant/ops/remove_point.h"
#include "support/sample_boundaries.h"
#include "support/sample_meshes.h"
#include "support/triangles.h"

using namespace pliant;
using namespace pliant::samples;

TEST_CASE("every point of every element is found, from any hint, and always in the same element", "[mesh][property]") {
  const int degree = GENERATE(range(1, 6));
  for (const Sample& sample : sample_meshes(degree)) {
    const Mesh& mesh = sample.mesh;
    CAPTURE(degree, sample.name);
    Random random(degree);
    Locator locator(mesh);
    for (int k = 0; k < 300; ++k) {
      const TriangleId t = random.integer(0, mesh.triangle_slots() - 1);
      const Barycentric xi = random.barycentric();
      const Point p = image(mesh, t, xi);
      CAPTURE(k, t, xi);
      const auto found = locator.find(p, t);
      check_location(mesh, p, found);
      CHECK(found->triangle == t);
      CHECK(is_same(locator.find(p), found));
      CHECK(is_same(Locator(mesh).find(p), found));
      CHECK(is_same(Locator(mesh).find(p, random.integer(0, mesh.triangle_slots() - 1)), found));
      CHECK(is_same(locator.find(p, random.integer(0, mesh.triangle_slots() - 1)), found));
      for (const TriangleId wrong : {-7, mesh.triangle_slots(), std::numeric_limits<TriangleId>::max()})
        CHECK(is_same(locator.find(p, wrong), found));
    }
  }
}

TEST_CASE("points on edges and vertices, or next to them, are found in the element there with the least number",
          "[mesh][property]") {
  const int degree = GENERATE(range(1, 6));
  for (const Sample& sample : sample_meshes(degree)) {
    const Mesh& mesh = sample.mesh;
    CAPTURE(degree, sample.name);
    Random random(degree);
    Locator locator(mesh);
    for (int k = 0; k < 150; ++k) {
      const TriangleId t = random.integer(0, mesh.triangle_slots() - 1);
      const int e = random.integer(0, 2);
      Barycentric xi{0, 0, 0};
      xi[index(e)] = k % 3 == 0 ? 1 : random.real(0, 1);
      xi[index((e + 1) % 3)] = 1 - xi[index(e)];
      const Point on = image(mesh, t, xi);
      const bool is_inner = mesh.twin(half_edge(t, e)) != none && k % 3 != 0;
      for (const double off : {0.0, 1e-15, 1e-13, 1e-12}) {
        const double angle = random.real(0, 6.28);
        const Point p = on + off * mesh.size() * Point{std::cos(angle), std::sin(angle)};
        CAPTURE(k, t, xi, off);
        const auto found = locator.find(p, t);
        if (!found && !is_inner && off > 0) continue;  // within 1e-12 of the outer boundary either answer is right
        check_location(mesh, p, found);
        CHECK(is_same(Locator(mesh).find(p, random.integer(0, mesh.triangle_slots() - 1)), found));
        const std::vector<TriangleId> all = containing(mesh, p);
        CHECK(std::ranges::count(all, found->triangle) == 1);
        if (off == 0 && found->triangle != t) CHECK(found->triangle == all.front());
      }
    }
  }
}

TEST_CASE("elements are found where triangles of the logical mesh are inverted", "[mesh]") {
  int inverted = 0;
  for (int seed = 0; seed < 6; ++seed) {
    Mesh mesh = meshed(samples::one_cell(2), 2, 0.1);
    shake(mesh, 200000, seed);
    REQUIRE(find_invalid(mesh).empty());
    Locator locator(mesh);
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
      inverted +=
          orient2d(mesh.point(mesh.corner(t, 0)), mesh.point(mesh.corner(t, 1)), mesh.point(mesh.corner(t, 2))) <= 0;
      for (const Barycentric& xi : samples::lattice(6))
        for (const TriangleId hint : {t, 0, TriangleId{none}}) {
          CAPTURE(seed, t, xi, hint);
          check_location(mesh, image(mesh, t, xi), locator.find(image(mesh, t, xi), hint));
        }
    }
  }
  CHECK(inverted > 0);
}

TEST_CASE("at a vertex where parts of the mesh touch, the element with the least number is found", "[mesh]") {
  samples::MeshBuilder builder(2);
  builder.data().boundary = samples::with_faces({"hourglass"});
  std::vector<PointId> v;
  for (const Point& p : {Point{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}) v.push_back(builder.add_vertex(p));
  builder.add_triangle(v[0], v[1], v[2], 0);
  builder.add_triangle(v[0], v[3], v[4], 0);
  const Mesh mesh(std::move(builder.data()));
  for (const TriangleId hint : {0, 1, TriangleId{none}}) {
    const auto found = Locator(mesh).find({0, 0}, hint);
    check_location(mesh, {0, 0}, found);
    CHECK(found->triangle == 0);
    CHECK(!Locator(mesh).find({0, 0.5}, hint));
  }
}

TEST_CASE("many points at once are found where they are found one by one", "[mesh][property]") {
  const int degree = GENERATE(range(1, 6));
  for (const Sample& sample : sample_meshes(degree)) {
    const Mesh& mesh = sample.mesh;
    CAPTURE(degree, sample.name);
    Random random(degree);
    const Box box = mesh.box();
    std::vector<Point> points;
    for (int k = 0; k < 300; ++k) {
      points.push_back({random.real(box.low.x, box.high.x), random.real(box.low.y, box.high.y)});
      points.push_back(mesh.point(mesh.corner(random.integer(0, mesh.triangle_slots() - 1), 0)));
    }
    points.push_back({std::nan(""), 0});
    points.push_back({1e300, -HUGE_VAL});
    points.push_back({1e300, -1e300});
    std::vector<std::optional<Location>> found(points.size()), again(points.size());
    Locator locator(mesh);
    locator.find_all(points, found);
    locator.find_all(points, again);
    for (std::size_t k = 0; k < points.size(); ++k) {
      CAPTURE(k, points[k].x, points[k].y);
      CHECK(is_same(found[k], again[k]));
      CHECK(is_same(found[k], Locator(mesh).find(points[k])));
    }
  }
  const Mesh mesh;
  Locator locator(mesh);
  locator.find_all({}, {});
  CHECK(!locator.find({0, 0}));
}

TEST_CASE("a walk from far along a band of many triangles ends early, and the point is found all the same", "[mesh]") {
  constexpr int length = 4000;
  samples::MeshBuilder builder(2);
  builder.data().boundary = samples::with_faces({"band"});
  std::vector<PointId> low, high;
  for (int k = 0; k <= length; ++k) {
    low.push_back(builder.add_vertex({double(k), 0}));
    high.push_back(builder.add_vertex({double(k), 1}));
  }
  for (std::size_t k = 0; k < length; ++k) {
    builder.add_triangle(low[k], low[k + 1], high[k], 0);
    builder.add_triangle(low[k + 1], high[k + 1], high[k], 0);
  }
  const Mesh mesh(std::move(builder.data()));
  Locator locator(mesh);
  const Point p{length - 0.4, 0.3};
  CHECK(!locator.walk(p, 0));
  check_location(mesh, p, locator.find(p, 0));
  check_location(mesh, p, Locator(mesh).find(p));
}

TEST_CASE("free slots are no elements, and no hints", "[mesh]") {
  Mesh mesh(samples::disk(2));
  std::vector<PointId> added;
  for (TriangleId t = 0, count = mesh.triangle_slots(); t < count; ++t)
    added.push_back(insert_point(mesh, t, {0.3, 0.3, 0.4}).vertex);
  for (const PointId v : added) REQUIRE(remove_inner_vertex(mesh, v) == Outcome::done);
  REQUIRE(mesh.triangle_count() < mesh.triangle_slots());
  Locator locator(mesh);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    const Point p{0.6 * std::cos(t), 0.6 * std::sin(t)};
    check_location(mesh, p, locator.find(p, t));
    check_location(mesh, p, Locator(mesh).find(p, t));
    check_location(mesh, p, Locator(mesh).find(p));
  }
}

TEST_CASE("points on and beside inner edges are found 1e9 widths from the origin, too", "[mesh][locate]") {
  const int degree = GENERATE(1, 2, 3, 5);
  CAPTURE(degree);
  const Mesh mesh(samples::disk(degree, 8, {2e9, -1e9}));
  Locator locator(mesh);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (int e = 0; e < 3; ++e) {
      if (mesh.twin(half_edge(t, e)) == none) continue;
      for (int k = 0; k <= 20; ++k) {
        Barycentric xi{};
        xi[index(e)] = 0.05 + 0.045 * k;
        xi[index((e + 1) % 3)] = 1 - xi[index(e)];
        const Point p = image(mesh, t, xi);
        const auto found = locator.find(p, t);
        REQUIRE(found);
        CHECK(distance(image(mesh, found->triangle, found->xi), p) <= mesh.tolerance());
      }
    }
}
