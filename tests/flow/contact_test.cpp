// tests/flow/contact_test.cpp: steps that would bring boundaries closer than the least gap.
#include <algorithm>
#include <numbers>

#include "flow_meshes.h"
#include "pliant/flow/advect.h"
#include "pliant/flow/advect_to.h"
#include "pliant/flow/boundary_gap.h"

using namespace pliant;
using namespace pliant::flow_meshes;

namespace {

/// Two round cells, with a gap of about 0.2 at the origin. The gap is exact where a curve begins on the axis.
MeshData two_disks(int degree) {
  samples::MeshBuilder builder(degree);
  samples::add_disk(builder, 16, {-1.1, 0}, 1, "west");
  samples::add_disk(builder, 16, {1.1, 0}, 1, "east");
  return std::move(builder.data());
}
Vector together(const Point& x, double) { return {x.x < 0 ? 1.0 : -1.0, 0}; }

AdvectOptions step_of(double dt, double min_gap) {
  AdvectOptions options;
  options.dt = dt;
  options.min_gap = min_gap;
  return options;
}

/// The least distance of points of two curves that are sampled densely.
double sampled_gap(const Mesh& mesh, CurveId a, CurveId b) {
  constexpr int samples = 640;
  const auto points = [&mesh](CurveId c) {
    std::vector<Point> all;
    const std::vector<double> breaks = mesh.spline(c).breaks();
    for (int i = 0; i < samples; ++i)
      all.push_back(mesh.spline(c).evaluate(breaks.front() + (breaks.back() - breaks.front()) * i / samples));
    return all;
  };
  double least = HUGE_VAL;
  const std::vector<Point> on_a = points(a), on_b = points(b);
  for (const Point& p : on_a)
    for (const Point& q : on_b) least = std::min(least, squared_length(q - p));
  return std::sqrt(least);
}

}  // namespace

TEST_CASE("the least gap of a mesh is that of its curves", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  const Mesh mesh(two_disks(degree));
  const auto gap = least_gap(mesh, 1);
  REQUIRE(gap);
  CHECK(gap->distance == Approx(sampled_gap(mesh, 0, 1)).margin(1e-4));
  CHECK(distance(gap->place, gap->other) == Approx(gap->distance));
  CHECK(gap->first == 0);
  CHECK(gap->second == 1);
  CHECK(mesh.constraint_curve(mesh.constraint(gap->edge)) == 0);
  CHECK(mesh.constraint_curve(mesh.constraint(gap->other_edge)) == 1);
  CHECK_FALSE(least_gap(mesh, 0.99 * gap->distance));
  CHECK_THAT(describe_gap(mesh, *gap), Catch::StartsWith("curve 0 (\"west\") and curve 1 (\"east\") are 0."));
}

TEST_CASE("corners, interfaces and round cells have no gap", "[flow]") {
  const int degree = GENERATE(1, 2, 3);
  for (const MeshData& data : {samples::disk(degree), two_rooms(degree)}) CHECK_FALSE(least_gap(Mesh(data), 0.4));
}

TEST_CASE("a step to a gap below the least one is not taken, and the mesh stays as it was", "[flow]") {
  const int degree = GENERATE(1, 2, 3);
  const StepPolicy policy = GENERATE(StepPolicy::refuse, StepPolicy::limit, StepPolicy::force);
  CAPTURE(degree);
  Mesh mesh(two_disks(degree));
  const double gap = least_gap(mesh, 1)->distance;
  AdvectOptions options = step_of(0.05, gap - 0.11);
  options.policy = policy;
  REQUIRE(advect(mesh, together, options).status == AdvectOutcome::Status::done);
  const MeshData before = mesh.to_data();
  const AdvectOutcome refused = advect(mesh, together, options);
  CHECK(refused.status == AdvectOutcome::Status::contact);
  CHECK(refused.dt == 0);
  REQUIRE(refused.report.notes.size() == 1);
  CHECK_THAT(refused.report.notes.front(), Catch::StartsWith("at time 0.1 curve 0 (\"west\") and curve 1 (\"east\")"));
  CHECK(mesh.to_data().points == before.points);
  CHECK(mesh.time == 0.05);
  options.min_gap = 0;
  CHECK(advect(mesh, together, options).status == AdvectOutcome::Status::done);
}

TEST_CASE("a mesh whose gap is too thin before the step is refused, whatever the step", "[flow]") {
  Mesh mesh(two_disks(2));
  const AdvectOutcome refused = advect(
      mesh,
      [](const Point& x, double) {
        return Vector{x.x, 0};
      },
      step_of(0.01, 0.5));
  CHECK(refused.status == AdvectOutcome::Status::contact);
  CHECK_THAT(refused.report.notes.front(), Catch::StartsWith("before the step, at time 0 "));
}

TEST_CASE("contact is found in other units, and for a velocity that the mesh carries", "[flow]") {
  const double factor = GENERATE(1.0, 1e-6, 1e6);
  MeshData data = scaled(two_disks(2), factor, {0, 0});
  samples::add_field(data, "v", 2, [factor](const Point& x) {
    return std::vector<double>{x.x < 0 ? factor : -factor, 0};
  });
  Mesh mesh(std::move(data));
  CHECK(advect_by_field(mesh, 0, step_of(0.02, 0.1 * factor)).status == AdvectOutcome::Status::done);
  CHECK(advect_by_field(mesh, 0, step_of(0.1, 0.1 * factor)).status == AdvectOutcome::Status::contact);
}

TEST_CASE("two bodies that a flow drives together are held apart, and spread along each other", "[flow]") {
  const int degree = GENERATE(1, 2, 3);
  const bool keep_area = GENERATE(false, true);
  CAPTURE(degree, keep_area);
  const VelocityField squeeze = [](const Point& x, double) { return Vector{-x.x, x.y}; };
  AdvectOptions options = step_of(0.01, 0.1);
  options.gap = GapPolicy::hold;
  options.keep_area = keep_area;
  Mesh mesh(two_disks(degree));
  double least = HUGE_VAL;
  bool is_held = false;
  for (int step = 0; step < 100; ++step) {
    CAPTURE(step);
    const AdvectOutcome outcome = advect(mesh, squeeze, options);
    REQUIRE(outcome.status == AdvectOutcome::Status::done);
    const auto held = std::ranges::find(outcome.report.values, "held", [](const auto& value) { return value.first; });
    REQUIRE(held != outcome.report.values.end());
    is_held = is_held || held->second > 0;
    least = std::min(least, sampled_gap(mesh, 0, 1));
  }
  CHECK(is_held);
  CHECK(least > 0.09);
  check_all(mesh);
  CHECK(mesh.box().high.y > 2);  // the flow alone would bring it to 2.7
  options.gap = GapPolicy::stop;
  Mesh other(two_disks(degree));
  AdvectOutcome outcome{};
  for (int step = 0; step < 100 && outcome.status != AdvectOutcome::Status::contact; ++step)
    outcome = advect(other, squeeze, options);
  CHECK(outcome.status == AdvectOutcome::Status::contact);
}

TEST_CASE("a body at rest stays as it is while another one is held back from it", "[flow]") {
  const int degree = GENERATE(2, 3);
  CAPTURE(degree);
  const MeshData data = two_disks(degree);
  AdvectOptions options = step_of(0.02, 0.1);
  options.gap = GapPolicy::hold;
  Mesh mesh(data);
  const VelocityField push = [](const Point& x, double) { return x.x < 0.03 ? Vector{-x.x + 0.1, 0.2} : Vector{}; };
  for (int step = 0; step < 25; ++step) {
    CAPTURE(step);
    REQUIRE(advect(mesh, push, options).status == AdvectOutcome::Status::done);
    REQUIRE(sampled_gap(mesh, 0, 1) > 0.08);
  }
  check_all(mesh);
  for (std::size_t i = 0; i < mesh.spline(1).points().size(); ++i)
    CHECK(mesh.spline(1).points()[i] == data.boundary.curves[1].spline.points()[i]);
}

TEST_CASE("where no gap is thin, holding gaps changes no bit", "[flow]") {
  const int degree = GENERATE(1, 2, 3);
  for (const MeshData& data : all(degree)) {
    Mesh free(data), held(data);
    AdvectOptions options = step_of(0.02, 0.01);
    const VelocityField flow = make_flow("taylor-green", {});
    REQUIRE(advect(free, flow, options).status == AdvectOutcome::Status::done);
    options.gap = GapPolicy::hold;
    REQUIRE(advect(held, flow, options).status == AdvectOutcome::Status::done);
    CHECK(free.to_data().points == held.to_data().points);
  }
}
