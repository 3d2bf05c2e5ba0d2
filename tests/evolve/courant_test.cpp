// tests/evolve/courant_test.cpp: how long a velocity takes to cross an element, and how fast it changes at fixed
// places.
#include "pliant/evolve/courant.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "pliant/evolve/steadiness.h"
#include "pliant/flow/advect.h"
#include "pliant/mesh/documents/document_unit.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

using Velocity = std::function<std::vector<double>(const Point&)>;

Mesh with_velocity(MeshData data, const Velocity& velocity) {
  samples::add_field(data, "velocity", 2, velocity);
  return Mesh(std::move(data));
}

double least_height(const Mesh& mesh) {
  double least = HUGE_VAL;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    const Point a = mesh.point(mesh.corner(t, 0)), b = mesh.point(mesh.corner(t, 1)), c = mesh.point(mesh.corner(t, 2));
    for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}})
      least = std::min(least, std::abs(cross(q - p, r - p)) / distance(p, q));
  }
  return least;
}

}  // namespace

TEST_CASE("a uniform velocity crosses the thinnest element in its height over the speed", "[evolve]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const Mesh mesh = with_velocity(degree == 1 ? samples::three_disks(1) : samples::disk(degree), [](const Point&) {
    return std::vector<double>{3, -4};
  });
  CHECK(crossing_time(mesh, 0) == Approx(least_height(mesh) / 5).epsilon(1e-12));
}

TEST_CASE("where nothing moves a step may be as long as it likes", "[evolve]") {
  CHECK(std::isinf(crossing_time(with_velocity(samples::disk(2),
                                               [](const Point&) {
                                                 return std::vector<double>{0, 0};
                                               }),
                                 0)));
}

TEST_CASE("times do not depend on the unit of length of a document", "[evolve]") {
  const auto scaled = [](double factor) {
    MeshData data = samples::disk(2);
    for (Point& p : data.points) p *= factor;
    for (Point& p : data.boundary.vertices) p *= factor;
    for (Curve& curve : data.boundary.curves)
      for (int i = 0; i < static_cast<int>(curve.spline.points().size()); ++i)
        curve.spline.set_point(i, factor * curve.spline.points()[static_cast<std::size_t>(i)]);
    samples::add_field(data, "velocity", 2, [factor](const Point&) {
      return std::vector<double>{3 * factor, 4 * factor};
    });
    normalize_unit(data);
    return Mesh(std::move(data));
  };
  const double expected = crossing_time(scaled(1), 0);
  CHECK(crossing_time(scaled(std::ldexp(1.0, 100)), 0) == expected);
  CHECK(crossing_time(scaled(std::ldexp(1.0, -300)), 0) == expected);
  // The same for what changes: a velocity that doubles in half a unit of time.
  for (const double factor : {1.0, std::ldexp(1.0, 100)}) {
    Mesh before = scaled(factor), after = scaled(factor);
    const Steadiness steadiness(before, 0);
    MeshData data = after.to_data();
    for (double& value : data.fields[0].values) value *= 2;
    Mesh doubled(std::move(data));
    doubled.time = 0.5;
    CHECK(steadiness.rate(doubled, 0) == Approx(1).epsilon(1e-12));  // half of the greatest speed, in half a unit
  }
}

TEST_CASE("a velocity is steady where it is the same at the same places, on any mesh", "[evolve]") {
  // A rigid rotation carried by a mesh that rotates: the control values stay, the places do not.
  const auto rotation = [](const Point& p) { return std::vector<double>{-p.y, p.x}; };
  const Mesh before = with_velocity(samples::disk(3), rotation);
  const Steadiness steadiness(before, 0);
  Mesh turned(samples::disk(3));
  AdvectOptions options;
  options.dt = 0.2;
  REQUIRE(advect(turned, make_flow("rotation", {}), options).status == AdvectOutcome::Status::done);
  const Mesh same = with_velocity(turned.to_data(), rotation);
  CHECK(steadiness.rate(same, 0) < 1e-11);
  Mesh carried(before.to_data());  // the field goes along unchanged: at fixed places it turns
  REQUIRE(advect(carried, make_flow("rotation", {}), options).status == AdvectOutcome::Status::done);
  CHECK(steadiness.rate(carried, 0) == Approx(2 * std::sin(0.1) / 0.2).epsilon(0.02));
}
