// tests/flow/advect_to_test.cpp: steps towards a time end there, and times stay round.
#include "pliant/flow/advect_to.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "pliant/mesh/documents/document_unit.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

using Status = AdvectOutcome::Status;

const VelocityField to_the_right = [](const Point&, double) { return Vector{1, 0}; };

AdvectOptions with_step(double dt) {
  AdvectOptions options;
  options.dt = dt;
  return options;
}

double value_of(const PassReport& report, const std::string& name) {
  for (const auto& [known, value] : report.values)
    if (known == name) return value;
  return std::nan("");
}

}  // namespace

TEST_CASE("a loop of steps of any length ends at the time exactly, with no step more than it takes", "[flow]") {
  const auto [dt, until, steps] = GENERATE(table<double, double, int>(
      {{0.1, 1, 10}, {0.05, 5, 100}, {0.3, 1, 4}, {1.0 / 3, 1, 3}, {0.7, 0.1, 1}, {0.01, 0.57, 57}, {1e-3, 0.1, 100}}));
  CAPTURE(dt, until, steps);
  Mesh mesh(samples::disk(2));
  int taken = 0;
  while (mesh.time < until && taken < 200) {
    const AdvectOutcome outcome = advect_to(mesh, to_the_right, with_step(dt), until);
    REQUIRE(outcome.status == Status::done);
    CHECK(value_of(outcome.report, "time") == mesh.time);
    ++taken;
  }
  CHECK(mesh.time == until);
  CHECK(taken == steps);
  const MeshData before = mesh.to_data();
  const AdvectOutcome late = advect_to(mesh, to_the_right, with_step(dt), until);
  CHECK(late.status == Status::late);
  CHECK(value_of(late.report, "dt") == 0);
  CHECK(value_of(late.report, "time") == until);
  CHECK(mesh.to_data().points == before.points);
}

TEST_CASE("the last step is as long as what is left", "[flow]") {
  Mesh mesh(samples::disk(2));
  mesh.time = 0.75;
  const Point before = mesh.point(0);
  const AdvectOutcome outcome = advect_to(mesh, to_the_right, with_step(10), 1);
  CHECK(outcome.status == Status::done);
  CHECK(outcome.dt == 0.25);
  CHECK(outcome.asked_dt == 0.25);
  CHECK(mesh.point(0).x == Approx(before.x + 0.25));
}

TEST_CASE("without a time to end at, steps of a round length keep the time round", "[flow]") {
  Mesh mesh(samples::disk(2));
  for (int k = 1; k <= 30; ++k) {
    advect_to(mesh, to_the_right, with_step(0.1));
    CHECK(mesh.time == k / 10.0);
  }
}

TEST_CASE("a limited step stays where it is proved safe, not at the time", "[flow]") {
  Mesh mesh(samples::disk(2));
  const VelocityField shear = [](const Point& p, double) { return Vector{8 * std::sin(6 * p.y), 0}; };
  AdvectOptions options = with_step(1);
  CHECK(advect_to(mesh, shear, options, 1).status == Status::unsafe);
  CHECK(mesh.time == 0);
  options.policy = StepPolicy::limit;
  const AdvectOutcome outcome = advect_to(mesh, shear, options, 1);
  CHECK(outcome.status == Status::limited);
  CHECK(outcome.asked_dt == 1);
  CHECK(mesh.time == outcome.dt);
  CHECK(mesh.time > 0);
  CHECK(mesh.time < 1);
}

TEST_CASE("a step that the time has no digits for is refused before the mesh moves", "[flow]") {
  Mesh mesh(samples::disk(2));
  mesh.time = 1e17;
  const MeshData before = mesh.to_data();
  CHECK(advect_to(mesh, to_the_right, with_step(1)).status == Status::no_progress);
  CHECK(mesh.to_data().points == before.points);
  CHECK(mesh.time == 1e17);
  CHECK(advect_to(mesh, to_the_right, with_step(100)).status == Status::done);
}

TEST_CASE("a step that is limited below the digits of the time is refused before the mesh moves", "[flow]") {
  Mesh mesh(samples::disk(2));
  mesh.time = 0x1p53;
  const MeshData before = mesh.to_data();
  const VelocityField shear = [](const Point& p, double) { return Vector{8 * std::sin(6 * p.y), 0}; };
  AdvectOptions options = with_step(2);
  options.policy = StepPolicy::limit;
  CHECK(advect_to(mesh, shear, options).status == Status::no_progress);
  CHECK(mesh.to_data().points == before.points);
  CHECK(mesh.time == 0x1p53);
}

TEST_CASE("velocities are those of the document, whatever unit the mesh is in", "[flow]") {
  MeshData data = samples::disk(2);
  const double factor = 0x1p100;
  for (Point& p : data.points) p *= factor;
  for (Curve& curve : data.boundary.curves)
    for (int i = 0; i < static_cast<int>(curve.spline.points().size()); ++i)
      curve.spline.set_point(i, factor * curve.spline.points()[static_cast<std::size_t>(i)]);
  normalize_unit(data);
  REQUIRE(data.boundary.unit != 1);
  Mesh large((MeshData(data))), small(samples::disk(2));
  const VelocityField turn = [](const Point& p, double) { return Vector{-p.y, p.x}; };
  advect_to(large, turn, with_step(0.1));
  advect_to(small, turn, with_step(0.1));
  for (PointId p = 0; p < small.point_slots(); ++p)
    CHECK(large.boundary().unit * large.point(p) == factor * small.point(p));
}

TEST_CASE("times become round only where rounding is a matter of a few bits", "[flow]") {
  CHECK(round_time(0.1 + 0.2, 0.1) == 0.3);
  CHECK(round_time(1.0 / 3, 0.1) == 1.0 / 3);
  const double between = 5 + 1e-12;
  CHECK(round_time(between, 0.05) == between);
  CHECK(round_time(5 * (1 + std::numeric_limits<double>::epsilon()), 0.05) == 5);
  CHECK(round_time(5 * (1 + std::numeric_limits<double>::epsilon()), 1e-9) != 5);  // not a billionth of the step
  CHECK(round_time(0, 1) == 0);
  CHECK(round_time(-0.7, 0.1) == -0.7);
}
