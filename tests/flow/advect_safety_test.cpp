// tests/flow/advect_safety_test.cpp: steps that would invert elements, and velocities that fail.
#include "flow_meshes.h"
#include "pliant/flow/advect.h"

using namespace pliant;
using namespace pliant::flow_meshes;

namespace {

/// A velocity far too rough for the meshes here: one step of length 1 folds elements.
Vector rough(const Point& x, double) { return {3 * std::sin(7 * x.y), 3 * std::cos(9 * x.x)}; }

AdvectOptions step_with(StepPolicy policy) {
  AdvectOptions options;
  options.dt = 1;
  options.policy = policy;
  return options;
}

bool same(const MeshData& a, const MeshData& b) {
  if (a.points != b.points || a.triangles != b.triangles || a.time != b.time) return false;
  if (a.boundary.vertices != b.boundary.vertices) return false;
  for (std::size_t c = 0; c < a.boundary.curves.size(); ++c)
    if (a.boundary.curves[c].spline.points() != b.boundary.curves[c].spline.points()) return false;
  return true;
}

double value(const PassReport& report, const std::string& name) {
  for (const auto& [key, number] : report.values)
    if (key == name) return number;
  return std::nan("");
}

}  // namespace

TEST_CASE("an unsafe step is refused with the element that blocks it, and changes nothing", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  for (const MeshData& data : all(degree)) {
    Mesh mesh(data);
    const MeshData before = mesh.to_data();
    const AdvectOutcome outcome = advect(mesh, rough, step_with(StepPolicy::refuse));
    CHECK(outcome.status == AdvectOutcome::Status::unsafe);
    CHECK(outcome.fraction < 1);
    CHECK(outcome.dt == 0);
    CHECK(outcome.blocking >= 0);
    CHECK(outcome.report.notes.size() == 1);
    CHECK(same(mesh.to_data(), before));
  }
}

TEST_CASE("a limited step is the safe step of that length, integrated again", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  for (const MeshData& data : all(degree)) {
    Mesh mesh(data);
    const AdvectOutcome outcome = advect(mesh, rough, step_with(StepPolicy::limit));
    REQUIRE(outcome.status == AdvectOutcome::Status::limited);
    CHECK(outcome.dt > 0);
    CHECK(outcome.dt <= 0.9 * outcome.fraction);
    CHECK(mesh.time == outcome.dt);
    CHECK(value(outcome.report, "dt") == outcome.dt);
    check_all(mesh);
    Mesh again(data);
    AdvectOptions shorter = step_with(StepPolicy::refuse);
    shorter.dt = outcome.dt;
    REQUIRE(advect(again, rough, shorter).status == AdvectOutcome::Status::done);
    CHECK(same(again.to_data(), mesh.to_data()));
  }
}

TEST_CASE("a forced step is taken, and its invalid elements are counted", "[flow]") {
  Mesh mesh(samples::disk(2));
  const AdvectOutcome outcome = advect(mesh, rough, step_with(StepPolicy::force));
  CHECK(outcome.status == AdvectOutcome::Status::done);
  CHECK(mesh.time == 1);
  const InvalidElements invalid = find_invalid(mesh);
  CHECK(value(outcome.report, "invalid") == double(invalid.invalid.size() + invalid.degenerate.size()));
  CHECK(check_mesh(mesh).empty());
}

TEST_CASE("a step that is safe for the flow but not for the polynomials is refused too", "[flow]") {
  // The step is half a turn. The flow is a rotation, but on straight ways all control points meet in the centre half
  // way.
  Mesh mesh(samples::disk(2));
  AdvectOptions options = step_with(StepPolicy::refuse);
  options.dt = 3.14159265358979;
  options.substeps = 100;
  const AdvectOutcome outcome = advect(mesh, make_flow("rotation", {}), options);
  CHECK(outcome.status == AdvectOutcome::Status::unsafe);
  CHECK(outcome.fraction == Approx(0.5).margin(2e-3));
  CHECK(outcome.fraction <= 0.5);
}

TEST_CASE("a velocity that is not finite stops the step and changes nothing", "[flow]") {
  const MeshData data = samples::disk(3);
  const Point hole = Mesh(data).point(Mesh(data).corner(0, 0));
  for (const Point& pole : {hole, Mesh(data).spline(0).evaluate(Mesh(data).spline(0).greville()[2])}) {
    Mesh mesh(data);
    const AdvectOutcome outcome = advect(
        mesh,
        [&](const Point& x, double) {
          return Vector{x == pole ? std::nan("") : 0.0, 0};
        },
        step_with(StepPolicy::limit));
    CHECK(outcome.status == AdvectOutcome::Status::not_finite);
    CHECK(outcome.dt == 0);
    CHECK(outcome.report.notes.size() == 1);
    CHECK(same(mesh.to_data(), Mesh(data).to_data()));
  }
}

TEST_CASE("the same step gives the same bits", "[flow]") {
  const VelocityField velocity = make_flow("taylor-green", {{"length", 4}});
  AdvectOptions options;
  options.dt = 0.1;
  Mesh a(samples::three_disks(3));
  Mesh b(samples::three_disks(3));
  for (int step = 0; step < 3; ++step) {
    advect(a, velocity, options);
    b = Mesh(b.to_data());  // through a document
    advect(b, velocity, options);
  }
  CHECK(same(a.to_data(), b.to_data()));
}
