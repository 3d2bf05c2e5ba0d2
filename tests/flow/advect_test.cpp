// tests/flow/advect_test.cpp: laws of a step: exact for linear flows, orders of error, reversible.
#include "pliant/flow/advect.h"

#include "flow_meshes.h"
#include "pliant/flow/runge_kutta.h"

using namespace pliant;
using namespace pliant::flow_meshes;

namespace {

AdvectOptions step_of(double dt, int substeps = 1) {
  AdvectOptions options;
  options.dt = dt;
  options.substeps = substeps;
  return options;
}

bool took(Mesh& mesh, const VelocityField& velocity, const AdvectOptions& options) {
  return advect(mesh, velocity, options).status == AdvectOutcome::Status::done;
}

}  // namespace

TEST_CASE("a uniform flow translates every control point and every spline", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  for (const MeshData& data : all(degree)) {
    const Mesh before(data);
    Mesh mesh(data);
    REQUIRE(took(mesh, make_flow("uniform", {{"u", 0.75}, {"v", -0.5}}), step_of(0.5)));
    CHECK(mesh.time == 0.5);
    for (PointId p = 0; p < mesh.point_slots(); ++p)
      CHECK(distance(mesh.point(p), before.point(p) + Vector{0.375, -0.25}) < 1e-14);
    for (CurveId c = 0; c < static_cast<CurveId>(data.boundary.curves.size()); ++c)
      for (std::size_t i = 0; i < mesh.spline(c).points().size(); ++i)
        CHECK(distance(mesh.spline(c).points()[i], before.spline(c).points()[i] + Vector{0.375, -0.25}) < 1e-14);
    check_all(mesh);
  }
}

TEST_CASE("if nothing moves, not a bit changes except the time", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  for (const MeshData& data : all(degree)) {
    Mesh mesh(data);
    REQUIRE(took(mesh, make_flow("uniform", {{"u", 0}}), step_of(0.25)));
    const MeshData after = mesh.to_data();
    CHECK(after.points == Mesh(data).to_data().points);
    CHECK(after.time == 0.25);
  }
}

TEST_CASE("a linear flow maps every control point by the Runge-Kutta polynomial of its matrix", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  const double a = 0.3, b = -1.1, c = 0.7, d = -0.4, dt = 0.3;
  const VelocityField velocity = [&](const Point& x, double) { return Vector{a * x.x + b * x.y, c * x.x + d * x.y}; };
  for (const MeshData& data : all(degree)) {
    const Mesh before(data);
    Mesh mesh(data);
    REQUIRE(took(mesh, velocity, step_of(dt)));
    for (PointId p = 0; p < mesh.point_slots(); ++p) {
      Point expected = before.point(p);
      Vector term = before.point(p);
      for (int k = 1; k <= 4; ++k) {
        term = dt / k * velocity(term, 0);
        expected += term;
      }
      CHECK(distance(mesh.point(p), expected) < 1e-13);
    }
    check_all(mesh);
  }
}

TEST_CASE("the error in time is of order 4", "[flow]") {
  const int degree = GENERATE(2, 3);
  const MeshData data = samples::disk(degree, 8, {0.4, 0.1}, 0.2);
  const VelocityField velocity = [flow = make_flow("taylor-green", {{"length", 3}})](const Point& x, double t) {
    return (1 + std::sin(3 * t)) * flow(x, t);
  };
  const auto after = [&](int substeps) {
    Mesh mesh(data);
    REQUIRE(took(mesh, velocity, step_of(0.5, substeps)));
    return mesh;
  };
  const Mesh reference = after(512);
  double coarse = difference(after(2), reference);
  for (const int substeps : {4, 8}) {
    const double fine = difference(after(substeps), reference);
    CAPTURE(degree, substeps, coarse, fine);
    CHECK(coarse / fine > 11);
    CHECK(coarse / fine < 23);
    coarse = fine;
  }
}

TEST_CASE("the error in space is of order degree + 1", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const VelocityField velocity = make_flow("taylor-green", {{"length", 2}});
  // The flow map within the elements is compared with the motion of single points. The elements are straight: curved
  // ones that get smaller without getting straighter would lose the order.
  const auto error = [&](double size) {
    Mesh mesh(scaled(two_rooms(degree), size, {0.3, 0.2}));
    const Mesh before = mesh;
    REQUIRE(took(mesh, velocity, step_of(0.5, 8)));
    double greatest = 0;
    std::vector<double> from(2 * static_cast<std::size_t>(mesh.net_size())), to(from.size());
    for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
      before.gather(t, from);
      mesh.gather(t, to);
      for (const Barycentric& xi : {Barycentric{0.2, 0.3, 0.5}, {0.6, 0.4, 0}, {0.1, 0.8, 0.1}, {0, 0.3, 0.7}}) {
        std::array<double, 2> x{}, y{};
        evaluate_net(degree, 2, from, xi, x);
        evaluate_net(degree, 2, to, xi, y);
        const Point start{x[0], x[1]};
        greatest = std::max(greatest, distance(start + carry(velocity, start, 0, 0.5, 8), {y[0], y[1]}));
      }
    }
    return greatest;
  };
  const double coarse = error(0.2);
  const double fine = error(0.1);
  CAPTURE(degree, coarse, fine);
  CHECK(std::log2(coarse / fine) > degree + 0.6);
}

TEST_CASE("splines stay smooth and edges stay their spans, whatever the flow", "[flow][property]") {
  const int degree = GENERATE(2, 3, 4);
  CAPTURE(degree);
  const VelocityField velocity = make_flow("lamb-oseen", {{"x", -1.5}, {"y", 0.2}, {"circulation", 3}, {"core", 0.5}});
  for (const MeshData& data : all(degree)) {
    Mesh mesh(data);
    for (int step = 0; step < 10; ++step) REQUIRE(took(mesh, velocity, step_of(0.05)));
    CHECK(mesh.time == Approx(0.5));
    CHECK(tangent_jump(mesh) < 1e-10);
    check_all(mesh);
  }
}

TEST_CASE("corners stay shared bit for bit", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  Mesh mesh(two_rooms(degree));
  const VelocityField velocity = make_flow("rankine", {{"x", 0.2}, {"y", 0.1}, {"core", 0.7}});
  for (int step = 0; step < 5; ++step) REQUIRE(took(mesh, velocity, step_of(0.1)));
  for (const Curve& curve : mesh.boundary().curves) {
    CHECK(curve.spline.points().front() == mesh.boundary().vertices[static_cast<std::size_t>(curve.start)]);
    CHECK(curve.spline.points().back() == mesh.boundary().vertices[static_cast<std::size_t>(curve.end)]);
  }
  check_all(mesh);
}

TEST_CASE("an incompressible flow nearly keeps the area, and --keep-area keeps it to rounding", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  const VelocityField velocity = make_flow("cylinder", {});
  const auto drift = [&](bool keep_area) {
    Mesh mesh(samples::disk(degree, 24, {-2.2, 0.9}, 0.5));
    const double before = enclosed_area(mesh);
    AdvectOptions options = step_of(0.05);
    options.keep_area = keep_area;
    for (int step = 0; step < 20; ++step) REQUIRE(took(mesh, velocity, options));
    check_all(mesh);
    return std::abs(enclosed_area(mesh) / before - 1);
  };
  CHECK(drift(false) < (degree == 1 ? 1e-2 : degree == 2 ? 1e-4 : 1e-5));
  CHECK(drift(true) < 1e-13);
}

TEST_CASE("a flow that is reversed brings everything back", "[flow]") {
  const int degree = GENERATE(2, 3, 4);
  CAPTURE(degree);
  const MeshData data = samples::disk(degree, 24, {0.5, 0.7}, 0.15);
  Mesh mesh(data);
  const VelocityField velocity = make_flow("reversed-vortex", {{"period", 1}});
  const Mesh before = mesh;
  for (int step = 0; step < 40; ++step) REQUIRE(took(mesh, velocity, step_of(1.0 / 40, 2)));
  // The mesh is stretched only mildly half way, so the error left is that of interpolating the curves.
  CHECK(difference(mesh, before) < 2e-3);
  for (const double t : before.spline(0).greville())
    CHECK(distance(mesh.spline(0).evaluate(t), before.spline(0).evaluate(t)) < (degree == 2 ? 1e-5 : 1e-6));
}

TEST_CASE("a step forward and a step back with negative dt undo each other", "[flow]") {
  Mesh mesh(samples::disk(3, 12, {0.2, 0.3}, 0.4));
  const Mesh before = mesh;
  const VelocityField velocity = make_flow("stagnation", {});
  REQUIRE(took(mesh, velocity, step_of(0.25, 50)));
  REQUIRE(took(mesh, velocity, step_of(-0.25, 50)));
  CHECK(difference(mesh, before) < 1e-11);
  CHECK(mesh.time == 0);
}

TEST_CASE("a velocity that the mesh carries moves its control points by v dt", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  for (MeshData data : all(degree)) {
    samples::add_field(data, "v", 2, [](const Point& x) { return std::vector{0.5 - x.y, x.x + 0.25 * x.y}; });
    Mesh mesh(data);
    const Mesh before = mesh;
    AdvectOutcome outcome = advect_by_field(mesh, 0, step_of(0.125));
    REQUIRE(outcome.status == AdvectOutcome::Status::done);
    for (PointId p = 0; p < mesh.point_slots(); ++p) {
      const Point x = before.point(p);
      CHECK(distance(mesh.point(p), x + 0.125 * Vector{0.5 - x.y, x.x + 0.25 * x.y}) < 1e-13);
    }
    CHECK(mesh.fields()[0].values == before.fields()[0].values);
    check_all(mesh);
  }
}
