// tests/flow/time_methods_test.cpp: the orders of the methods in time, and what adaptive steps promise.
#include <random>

#include "flow_meshes.h"
#include "pliant/flow/advect.h"
#include "pliant/flow/advect_to.h"
#include "pliant/flow/carry_adaptively.h"
#include "pliant/flow/runge_kutta.h"

using namespace pliant;
using namespace pliant::flow_meshes;

namespace {

using Status = AdvectOutcome::Status;

/// A smooth flow that changes in time, with no symmetry that could raise an order.
Vector unsteady(const Point& x, double t) {
  return {std::sin(1.3 * x.y + 2 * t) + 0.2 * x.x * x.y, std::cos(1.7 * x.x - t) * (1 + 0.5 * std::sin(3 * t))};
}

const std::vector<Point> starts{{0.1, 0.2}, {-0.7, 0.4}, {1.3, -0.6}, {0.5, 1.1}};

/// The greatest error at t = 1 of these points after so many equal steps.
double error_of(TimeMethod method, int steps) {
  const AdaptiveMotion exact = carry_adaptively(unsteady, starts, 0, 1, 1e-13);
  REQUIRE(exact.why.empty());
  std::vector<Vector> moved(starts.size());
  if (method != TimeMethod::dopri5) {
    for (std::size_t i = 0; i < starts.size(); ++i) moved[i] = carry(unsteady, starts[i], 0, 1, steps, method);
  } else {
    std::vector<Point> at = starts;
    for (int k = 0; k < steps; ++k) {  // a tolerance so large that each is one step
      const AdaptiveMotion step = carry_adaptively(unsteady, at, 1.0 * k / steps, 1.0 / steps, 1e9);
      REQUIRE(step.steps == 1);
      for (std::size_t i = 0; i < at.size(); ++i) at[i] += step.moved[i];
    }
    for (std::size_t i = 0; i < at.size(); ++i) moved[i] = at[i] - starts[i];
  }
  double greatest = 0;
  for (std::size_t i = 0; i < starts.size(); ++i)
    greatest = std::max(greatest, std::hypot(moved[i].x - exact.moved[i].x, moved[i].y - exact.moved[i].y));
  return greatest;
}

AdvectOptions options_of(double dt, TimeMethod method, int substeps = 1) {
  AdvectOptions options;
  options.dt = dt;
  options.method = method;
  options.substeps = substeps;
  return options;
}

}  // namespace

TEST_CASE("each method has its order in time: 1, 2, 4 and 5", "[flow]") {
  const auto [method, order] = GENERATE(table<TimeMethod, int>(
      {{TimeMethod::euler, 1}, {TimeMethod::midpoint, 2}, {TimeMethod::rk4, 4}, {TimeMethod::dopri5, 5}}));
  const int steps = order == 1 ? 256 : order == 2 ? 64 : 16;
  const double coarse = error_of(method, steps), fine = error_of(method, 2 * steps);
  CAPTURE(order, coarse, fine, std::log2(coarse / fine));
  CHECK(std::abs(std::log2(coarse / fine) - order) < 0.3);
}

TEST_CASE("meshes move with the order of the method too", "[flow]") {
  const auto [method, order] =
      GENERATE(table<TimeMethod, int>({{TimeMethod::euler, 1}, {TimeMethod::midpoint, 2}, {TimeMethod::rk4, 4}}));
  const int degree = GENERATE(1, 2, 3, 4);
  const MeshData data = samples::disk(degree, 8, {0.4, 0.1}, 0.2);
  const auto after = [&](TimeMethod by, int substeps) {
    Mesh mesh(data);
    REQUIRE(advect(mesh, unsteady, options_of(0.2, by, substeps)).status == Status::done);
    check_all(mesh);
    return mesh;
  };
  const Mesh reference = after(TimeMethod::rk4, 256);
  const double coarse = difference(after(method, 8), reference), fine = difference(after(method, 16), reference);
  CAPTURE(degree, order, coarse, fine);
  CHECK(std::abs(std::log2(coarse / fine) - order) < 0.3);
}

TEST_CASE("adaptive steps keep the error of a mesh about the tolerance, and need more steps for a smaller one",
          "[flow]") {
  const int degree = GENERATE(2, 3);
  const MeshData data = samples::disk(degree, 8, {0.4, 0.1}, 0.2);
  Mesh reference(data);
  REQUIRE(advect(reference, unsteady, options_of(0.5, TimeMethod::rk4, 512)).status == Status::done);
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    Mesh mesh(data), again(data);
    AdvectOptions options = options_of(0.5, TimeMethod::dopri5);
    options.tolerance = tolerance;
    REQUIRE(advect(mesh, unsteady, options).status == Status::done);
    REQUIRE(advect(again, unsteady, options).status == Status::done);
    CAPTURE(degree, tolerance);
    CHECK(difference(mesh, reference) <= 10 * tolerance);
    CHECK(mesh.to_data().points == again.to_data().points);
    CHECK(mesh.time == 0.5);
    check_all(mesh);
  }
  int last = 0;
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    const AdaptiveMotion motion = carry_adaptively(unsteady, starts, 0, 1, tolerance);
    CHECK(motion.steps > last);
    last = motion.steps;
  }
}

TEST_CASE("adaptive steps find a short event within a long step", "[flow]") {
  // At t = 0.7 the flow jumps by 1 within about 0.05.
  const VelocityField jump = [](const Point&, double t) {
    const double z = (t - 0.7) / 0.05;
    return Vector{std::exp(-z * z) / (0.05 * std::sqrt(std::acos(-1.0))), 1};
  };
  const AdaptiveMotion motion = carry_adaptively(
      [&](const Point& x, double t) {
        return jump(x, t) + Vector{0, std::cos(5 * t)};
      },
      starts, 0, 1, 1e-8);
  REQUIRE(motion.why.empty());
  for (const Vector& moved : motion.moved) CHECK(moved.x == Approx(1).margin(1e-6));
}

TEST_CASE("adaptive steps go back in time, stand still, and carry no points", "[flow]") {
  const AdaptiveMotion there = carry_adaptively(unsteady, starts, 0, 0.5, 1e-12);
  std::vector<Point> ends = starts;
  for (std::size_t i = 0; i < ends.size(); ++i) ends[i] += there.moved[i];
  const AdaptiveMotion back = carry_adaptively(unsteady, ends, 0.5, -0.5, 1e-12);
  for (std::size_t i = 0; i < ends.size(); ++i) CHECK(distance(ends[i] + back.moved[i], starts[i]) < 1e-11);
  const AdaptiveMotion still = carry_adaptively([](const Point&, double) { return Vector{}; }, starts, 0, 3, 1e-12);
  CHECK(still.steps == 1);
  CHECK(still.moved == std::vector<Vector>(starts.size()));
  CHECK(carry_adaptively(unsteady, {}, 0, 1, 1e-12).moved.empty());
}

TEST_CASE("adaptive steps end with words where they cannot meet the tolerance, and the mesh is as it was", "[flow]") {
  const VelocityField velocity = GENERATE(VelocityField(unsteady), VelocityField([](const Point& x, double t) {
                                            return Vector{1e3 * x.x, t > 0.1 ? -1e3 : 1e3};
                                          }),
                                          VelocityField([](const Point& x, double) {
                                            return Vector{std::floor(1e7 * x.y) * 1e9, std::floor(1e9 * x.x)};
                                          }));
  Mesh mesh(samples::disk(2));
  const MeshData before = mesh.to_data();
  AdvectOptions options = options_of(0.5, TimeMethod::dopri5);
  options.tolerance = 1e-40;
  const AdvectOutcome outcome = advect(mesh, velocity, options);
  REQUIRE(outcome.status == Status::too_many_steps);
  REQUIRE(outcome.report.notes.size() == 1);
  CHECK(outcome.report.notes[0].find("tolerance 1e-40: at time 0") != std::string::npos);
  CHECK(mesh.to_data().points == before.points);
  CHECK(mesh.time == before.time);
}

TEST_CASE("adaptive steps end where the velocity ceases to be finite or to be there", "[flow]") {
  Mesh mesh(samples::disk(2));
  const AdvectOptions options = options_of(1, TimeMethod::dopri5);
  const AdvectOutcome wall = advect(
      mesh,
      [](const Point&, double t) {
        return Vector{t < 0.3 ? 1 : HUGE_VAL, 0};
      },
      options);
  CHECK(wall.status == Status::too_many_steps);
  CHECK(wall.report.notes.at(0).find("the velocity is not finite near (") != std::string::npos);
  const AdvectOutcome start = advect(
      mesh,
      [](const Point&, double) {
        return Vector{HUGE_VAL, 0};
      },
      options);
  CHECK(start.status == Status::not_finite);
  for (const TimeMethod method : {TimeMethod::rk4, TimeMethod::dopri5}) {
    const AdvectOutcome nowhere = advect(
        mesh,
        [](const Point&, double t) {
          if (t > 0.2) throw NoVelocity("nothing after 0.2");
          return Vector{1, 0};
        },
        options_of(1, method));
    CHECK(nowhere.status == Status::no_velocity);
    CHECK(nowhere.report.notes.at(0) == "nothing after 0.2");
  }
  CHECK(mesh.time == 0);
}

TEST_CASE("a tolerance is a length of the document, whatever the mesh's unit", "[flow]") {
  const auto moved = [](double scale) {
    MeshData data = scaled(samples::disk(2), scale, {0, 0});
    const double unit = scale == 1 ? 1 : scale;
    if (scale != 1) data = scaled(std::move(data), 1 / scale, {0, 0});
    data.boundary.unit = unit;
    Mesh mesh(std::move(data));
    AdvectOptions options = options_of(0.25, TimeMethod::dopri5);
    options.tolerance = 1e-5 * scale;
    const VelocityField velocity = [&](const Point& x, double t) { return scale * unsteady(x / scale, t); };
    REQUIRE(advect_to(mesh, velocity, options).status == Status::done);
    return mesh.to_data().points;
  };
  CHECK(moved(0x1p100) == moved(1));
}

TEST_CASE("a velocity with its acceleration moves meshes with order 2, alone with order 1", "[flow]") {
  const int degree = GENERATE(1, 2, 3);
  const bool accelerated = GENERATE(false, true);
  // Rotation about the origin: v = w x, a = -w² x, set anew before each step, as a solver would.
  const double w = 1.5;
  const auto error = [&](int steps) {
    Mesh mesh(two_rooms(degree));
    const Mesh before = mesh;
    for (int k = 0; k < steps; ++k) {
      MeshData data = mesh.to_data();
      data.fields.clear();
      samples::add_field(data, "v", 2, [&](const Point& x) { return std::vector{-w * x.y, w * x.x}; });
      samples::add_field(data, "a", 2, [&](const Point& x) { return std::vector{-w * w * x.x, -w * w * x.y}; });
      mesh = Mesh(std::move(data));
      AdvectOptions options;
      options.dt = 0.4 / steps;
      REQUIRE(advect_by_field(mesh, 0, options, accelerated ? 1 : none).status == Status::done);
      check_all(mesh);
    }
    double greatest = 0;
    const double c = std::cos(0.4 * w), s = std::sin(0.4 * w);
    for (PointId p = 0; p < mesh.point_slots(); ++p) {
      const Point x = before.point(p);
      greatest = std::max(greatest, distance(mesh.point(p), {c * x.x - s * x.y, s * x.x + c * x.y}));
    }
    return greatest;
  };
  const double coarse = error(8), fine = error(16);
  CAPTURE(degree, accelerated, coarse, fine);
  CHECK(std::abs(std::log2(coarse / fine) - (accelerated ? 2 : 1)) < 0.2);
}
