// tests/flow/cusps_test.cpp: meshes with cusps move, and their cusps stay cusps.
#include <random>

#include "flow_meshes.h"
#include "mesh/curved_samples.h"
#include "pliant/flow/advect.h"
#include "support/sample_boundaries.h"

using namespace pliant;
using namespace pliant::flow_meshes;

namespace {

/// Between the x-axis and the parabola y = x², whose tangents agree in the origin.
BoundaryComplex horn() {
  BoundaryComplex b = samples::with_faces({"horn"});
  b.vertices = {{0, 0}, {1, 0}, {1, 1}};
  b.curves.push_back(samples::open_curve(b, "wall", 0, 1, {{0.5, 0}}, 0));
  b.curves.push_back(samples::open_curve(b, "side", 1, 2, {{1, 0.5}}, 0));
  b.curves.push_back(samples::open_curve(b, "parabola", 2, 0, {{0.5, 0}}, 0));
  return b;
}

/// The angle between the tangents of the boundary's curves that end in the vertex (two of them).
double angle_at(const Mesh& mesh, int vertex) {
  std::vector<Vector> tangents;
  for (const Curve& curve : mesh.boundary().curves) {
    const auto& points = curve.spline.points();
    if (curve.start == vertex) tangents.push_back(points[1] - points[0]);
    if (curve.end == vertex) tangents.push_back(points[points.size() - 2] - points.back());
  }
  REQUIRE(tangents.size() == 2);
  return std::abs(std::atan2(cross(tangents[0], tangents[1]), dot(tangents[0], tangents[1])));
}

}  // namespace

TEST_CASE("cusps stay cusps while the mesh moves, in any smooth flow", "[flow][property]") {
  const int degree = GENERATE(3, 4, 5);
  const bool moon = GENERATE(false, true);
  const int seed = GENERATE(range(0, 6));
  CAPTURE(degree, moon, seed);
  Mesh mesh = samples::meshed(moon ? samples::crescent(0) : horn(), degree, 0.05);
  REQUIRE(mesh.boundary().cusps.size() == 1);
  std::mt19937_64 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> any(-1, 1);
  const double a = any(random), b = any(random), c = any(random), d = any(random);
  const VelocityField velocity = [&](const Point& x, double t) {
    return Vector{a * std::sin(2 * x.y + t) + c, b * std::cos(1.5 * x.x) + d * x.y};
  };
  AdvectOptions options;
  options.dt = 0.02;
  options.policy = StepPolicy::limit;
  int whole = 0;
  for (int step = 0; step < 10; ++step) {
    const AdvectOutcome outcome = advect(mesh, velocity, options);
    if (outcome.status == AdvectOutcome::Status::done) ++whole;
    check_all(mesh);
    CHECK(angle_at(mesh, mesh.boundary().cusps[0]) < 1e-12);
  }
  CHECK(whole == 10);
}

TEST_CASE("at a cusp the wall that rests stays as it is, bit for bit", "[flow]") {
  Mesh mesh = samples::meshed(horn(), 2, 0.05);
  const std::vector<Point> wall = mesh.spline(0).points();
  // No slip at y = 0.
  const VelocityField velocity = [](const Point& x, double) { return Vector{3 * x.y, 0.5 * x.y * x.y}; };
  AdvectOptions options;
  options.dt = 0.02;
  for (int step = 0; step < 10; ++step) {
    REQUIRE(advect(mesh, velocity, options).status == AdvectOutcome::Status::done);
    check_all(mesh);
  }
  CHECK(mesh.spline(0).points() == wall);
}

TEST_CASE("a cusp that is carried as a velocity of the mesh stays one", "[flow]") {
  MeshData data = samples::meshed(horn(), 2, 0.05).to_data();
  samples::add_field(data, "v", 2, [](const Point& x) { return std::vector{0.3 - x.y + 0.1 * x.x, x.x}; });
  Mesh mesh(std::move(data));
  AdvectOptions options;
  options.dt = 0.05;
  for (int step = 0; step < 5; ++step) {
    REQUIRE(advect_by_field(mesh, 0, options).status == AdvectOutcome::Status::done);
    check_all(mesh);
    CHECK(angle_at(mesh, mesh.boundary().cusps[0]) < 1e-12);
  }
}

TEST_CASE("a step that closes a cusp's element is refused", "[flow]") {
  Mesh mesh = samples::meshed(horn(), 2, 0.05);
  const MeshData before = mesh.to_data();
  AdvectOptions options;
  options.dt = 1;
  // The parabola comes down upon the wall, and through it.
  const AdvectOutcome outcome = advect(
      mesh,
      [](const Point& x, double) {
        return Vector{0, -x.y * (2 + x.x)};
      },
      options);
  CHECK(advect(
            mesh,
            [](const Point& x, double) {
              return Vector{0, x.y > 0 ? -30 * x.x * x.x : 0};
            },
            options)
            .status == AdvectOutcome::Status::unsafe);
  CHECK((outcome.status == AdvectOutcome::Status::done || outcome.status == AdvectOutcome::Status::unsafe));
  if (outcome.status == AdvectOutcome::Status::done)
    check_all(mesh);
  else
    CHECK(mesh.to_data().points == before.points);
}
