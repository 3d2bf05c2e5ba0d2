// tests/flow/mesh_flow_test.cpp: the velocity of another mesh: exact for its polynomials, its order, and outside.
#include "pliant/flow/mesh_flow.h"

#include <random>

#include "flow_meshes.h"
#include "mesh/curved_samples.h"
#include "pliant/flow/advect.h"
#include "pliant/mesh/documents/document_unit.h"
#include "pliant/mesh/interpolate_nodes.h"

using namespace pliant;
using namespace pliant::flow_meshes;
using Catch::Matchers::Contains;

namespace {

using Outside = MeshFlow::Outside;
using Function = std::function<Vector(const Point&)>;

Mesh with_velocity(Mesh mesh, const Function& velocity, double time = 0, FaceId face = none) {
  std::string why;
  mesh.set_field(make_field(
      mesh, "velocity", 2, face,
      [&](const Point& x, std::span<double> value) {
        const Vector v = velocity(x);
        value[0] = v.x;
        value[1] = v.y;
      },
      why));
  REQUIRE(why.empty());
  mesh.time = time;
  return mesh;
}

void add(MeshFlow& flow, Mesh mesh) {
  const int field = static_cast<int>(mesh.fields().size()) - 1;
  flow.add(std::move(mesh), field);
}

std::string refusal(MeshFlow& flow, const Point& place, double time) {
  try {
    flow.velocity(place, time);
  } catch (const NoVelocity& e) {
    return e.what();
  }
  return "none";
}

double error(const Vector& a, const Vector& b) { return std::hypot(a.x - b.x, a.y - b.y); }

std::vector<Point> random_places(int count, unsigned seed, const Point& low, const Point& high) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Point> places;
  for (int k = 0; k < count; ++k) {
    const double x = part(random), y = part(random);
    places.push_back({low.x + x * (high.x - low.x), low.y + y * (high.y - low.y)});
  }
  return places;
}

}  // namespace

TEST_CASE("the flow of a mesh is exact for polynomials of its degree, linear in time", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4, 5);
  const auto velocity = [&](const Point& x, double t) {
    const double r = x.x - 0.3 * x.y + 0.1;
    return (1 + 2 * t) * Vector{std::pow(r, degree), 1 - std::pow(x.y, degree) + x.x};
  };
  MeshFlow flow("flow.json", Outside::refuse);
  for (const double t : {0.0, 0.5, 2.0})
    add(flow, with_velocity(
                  Mesh(two_rooms(degree)), [&](const Point& x) { return velocity(x, t); }, t));
  for (const Point& x : random_places(200, 3, {0, 0}, {2, 1}))
    for (const double t : {0.0, 0.1, 0.5, 1.75, 2.0}) CHECK(error(flow.velocity(x, t), velocity(x, t)) < 1e-12);
}

TEST_CASE("the flow of a mesh has order degree + 1 in space and 2 between frames", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const VelocityField exact = make_flow("taylor-green", {{"length", 2}, {"nu", 0.1}});
  const auto error_in_space = [&](double size) {
    MeshFlow flow("flow.json", Outside::refuse);
    add(flow,
        with_velocity(Mesh(scaled(two_rooms(degree), size, {0.3, 0.2})), [&](const Point& x) { return exact(x, 0); }));
    double greatest = 0;
    for (const Point& x : random_places(500, 5, {0.3, 0.2}, {0.3 + 2 * size, 0.2 + size}))
      greatest = std::max(greatest, error(flow.velocity(x, 0), exact(x, 0)));
    return greatest;
  };
  const double coarse = error_in_space(0.2), fine = error_in_space(0.1);
  CAPTURE(degree, coarse, fine);
  CHECK(std::log2(coarse / fine) > degree + 0.6);
  const auto error_in_time = [&](double step) {
    MeshFlow flow("flow.json", Outside::refuse);
    for (int k = 0; k < 2; ++k)
      add(flow, with_velocity(
                    Mesh(two_rooms(degree)),
                    [&](const Point& x) {
                      return (1 + std::sin(k * step)) * Vector{x.x, 1};
                    },
                    k * step));
    return error(flow.velocity({0.4, 0.7}, 0.5 * step), (1 + std::sin(0.5 * step)) * Vector{0.4, 1});
  };
  CHECK(std::log2(error_in_time(0.2) / error_in_time(0.1)) > 1.9);
}

TEST_CASE("a mesh that moves by its own flow from a file has the order of space", "[flow]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const VelocityField exact = make_flow("taylor-green", {{"length", 3}});
  const auto difference = [&](double size) {
    const Mesh start(scaled(two_rooms(degree), size, {0.3, 0.2}));
    MeshFlow flow("flow.json", Outside::refuse);
    add(flow, with_velocity(Mesh(scaled(two_rooms(degree), 1.5 * size, {0.3 - 0.5 * size, 0.2 - 0.25 * size})),
                            [&](const Point& x) { return exact(x, 0); }));
    Mesh by_file = start, by_name = start;
    AdvectOptions options;
    options.dt = 0.1 * size;
    REQUIRE(advect(
                by_file, [&](const Point& x, double t) { return flow.velocity(x, t); }, options)
                .status == AdvectOutcome::Status::done);
    REQUIRE(advect(by_name, exact, options).status == AdvectOutcome::Status::done);
    check_all(by_file);
    double greatest = 0;
    for (PointId p = 0; p < start.point_slots(); ++p)
      greatest = std::max(greatest, distance(by_file.point(p), by_name.point(p)));
    return greatest / options.dt;
  };
  const double coarse = difference(0.2), fine = difference(0.1);
  CAPTURE(degree, coarse, fine);
  CHECK(std::log2(coarse / fine) > degree + 0.5);
}

TEST_CASE("where the last place was found does not change the velocity", "[flow][property]") {
  const int degree = GENERATE(1, 2, 3);
  int number = 0;
  for (const auto& sample : samples::sample_meshes(degree)) {
    CAPTURE(degree, number++);
    const auto make = [&](MeshFlow& flow) {
      add(flow, with_velocity(sample.mesh, [](const Point& x) { return Vector{std::sin(9 * x.x), x.y * x.x}; }));
    };
    MeshFlow forward("flow.json", Outside::nearest), backward("flow.json", Outside::nearest);
    make(forward);
    make(backward);
    const Box box = sample.mesh.box();
    const auto places = random_places(300, 11, box.low, box.high);
    std::vector<Vector> one(places.size()), other(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) one[k] = forward.velocity(places[k], 0);
    for (std::size_t k = places.size(); k-- > 0;) other[k] = backward.velocity(places[k], 0);
    CHECK(one == other);
  }
}

TEST_CASE("curved meshes of many shapes move in the flow of another mesh, and stay sound", "[flow][property]") {
  const int degree = GENERATE(1, 2, 3);
  const double time_step = GENERATE(0.01, 0.1);
  for (const auto& sample : samples::sample_meshes(degree)) {
    CAPTURE(degree, sample.name);
    const Box box = sample.mesh.box();
    const double size = sample.mesh.size();
    // A rectangle around the mesh, but for a part of it, which is outside.
    MeshFlow flow("flow.jsonl", Outside::nearest);
    for (const double t : {0.0, 0.05, 0.2}) {
      const Mesh around(scaled(two_rooms(degree), 0.4 * size, box.low));
      add(flow, with_velocity(
                    around,
                    [&](const Point& x) {
                      return Vector{0.1 * (x.y - box.low.y) + t, 0.1 * x.x};
                    },
                    t));
    }
    AdvectOptions options;
    options.dt = time_step;
    options.policy = StepPolicy::limit;
    Mesh mesh = sample.mesh;
    const AdvectOutcome outcome = advect(
        mesh, [&](const Point& x, double t) { return flow.velocity(x, t); }, options);
    CHECK((outcome.status == AdvectOutcome::Status::done || outcome.status == AdvectOutcome::Status::limited ||
           outcome.status == AdvectOutcome::Status::unsafe));
    CHECK((outcome.status == AdvectOutcome::Status::unsafe || mesh.time > 0));
    check_all(mesh);
  }
}

TEST_CASE("places on curved boundaries count as inside, and beyond them as outside", "[flow]") {
  const int degree = GENERATE(2, 3, 4);
  MeshFlow flow("flow.json", Outside::refuse), nearest("flow.json", Outside::nearest);
  const Mesh disk(samples::disk(degree));
  const auto linear = [](const Point& x) { return Vector{1 + x.x, 2 - x.y}; };
  add(flow, with_velocity(disk, linear));
  add(nearest, with_velocity(disk, linear));
  const BSpline& curve = disk.spline(0);
  for (int k = 0; k < 500; ++k) {
    const double t = curve.breaks().front() + (curve.breaks().back() - curve.breaks().front()) * k / 500;
    const Point on = curve.evaluate(t);
    const Vector tangent = curve.derivative(t, true);
    const Vector out = Vector{tangent.y, -tangent.x} / std::hypot(tangent.x, tangent.y);
    for (const double off : {0.0, -1e-13, 1e-13, 1e-10, -1e-10})
      CHECK(error(flow.velocity(on + off * out, 0), linear(on)) < 1e-9);
    CHECK_THROWS_AS(flow.velocity(on + 1e-6 * out, 0), NoVelocity);
    for (const double off : {1e-6, 1e-3, 0.3, 5.0})  // the disk is convex: the foot is the same place
      CHECK(error(nearest.velocity(on + off * out, 0), linear(on)) < 1e-9);
  }
}

TEST_CASE("outside, the place and the time are named, or the nearest frame is taken", "[flow]") {
  const auto make = [](MeshFlow& flow) {
    for (const double t : {1.0, 2.0})
      add(flow, with_velocity(
                    Mesh(two_rooms(2)),
                    [&](const Point&) {
                      return Vector{t, 0};
                    },
                    t));
  };
  MeshFlow flow("f.jsonl", Outside::refuse), nearest("f.jsonl", Outside::nearest);
  make(flow);
  make(nearest);
  CHECK_THAT(refusal(flow, {0.5, 0.5}, 0.25), Contains("time 0.25 is before the first frame of f.jsonl, at time 1"));
  CHECK_THAT(refusal(flow, {0.5, 0.5}, 2.5), Contains("time 2.5 is after the last frame of f.jsonl, at time 2"));
  CHECK_THAT(refusal(flow, {2.25, 0.5}, 1.5),
             Contains("the point (2.25, 0.5), at time 1.5, is outside the mesh of f.jsonl at time 1, by 0.25"));
  CHECK(refusal(flow, {0.5, 0.5}, 2 + 1e-14) == "none");  // a sum of steps
  CHECK(nearest.velocity({0.5, 0.5}, -7).x == Approx(1));
  CHECK(nearest.velocity({9, 9}, 7).x == Approx(2));
  CHECK(nearest.velocity({-3, 0.5}, 1.25).x == Approx(1.25));
  CHECK_FALSE(is_finite(nearest.velocity({HUGE_VAL, 0}, 1)));
  MeshFlow single("f.json", Outside::refuse);
  add(single, with_velocity(
                  Mesh(two_rooms(2)),
                  [](const Point&) {
                    return Vector{1, 0};
                  },
                  3));
  CHECK(refusal(single, {0.5, 0.5}, -100) == "none");
  CHECK_THAT(refusal(single, {0.5, -1}, 4), Contains("at time 4, is outside the mesh of f.json, by 1;"));
}

TEST_CASE("a velocity by face jumps where its faces meet", "[flow]") {
  const int degree = GENERATE(1, 2, 3);
  Mesh mesh = with_velocity(
      Mesh(two_rooms(degree)),
      [](const Point&) {
        return Vector{1, 2};
      },
      0, 0);
  mesh = with_velocity(
      mesh,
      [](const Point& x) {
        return Vector{-x.x, 5};
      },
      0, 1);
  MeshFlow flow("f.json", Outside::refuse);
  add(flow, std::move(mesh));
  CHECK(error(flow.velocity({0.999, 0.4}, 0), {1, 2}) < 1e-12);
  CHECK(error(flow.velocity({1.001, 0.4}, 0), {-1.001, 5}) < 1e-12);
  const Vector between = flow.velocity({1, 0.4}, 0);
  CHECK(std::min(error(between, {1, 2}), error(between, {-1, 5})) < 1e-12);
}

TEST_CASE("a flow in a mesh of extreme size is in the units of its document", "[flow]") {
  const double scale = GENERATE(0x1p200, 0x1p-200);
  MeshData data = with_velocity(Mesh(two_rooms(2)), [](const Point& x) { return Vector{x.x, 3}; }).to_data();
  data = scaled(std::move(data), scale, {0, 0});
  normalize_unit(data);
  REQUIRE(data.boundary.unit != 1);
  MeshFlow flow("f.json", Outside::refuse);
  add(flow, Mesh(std::move(data)));
  CHECK(error(flow.velocity(scale * Point{0.7, 0.3}, 0), {0.7, 3}) < 1e-12);
  CHECK_THROWS_AS(flow.velocity(scale * Point{2.7, 0.3}, 0), NoVelocity);
}
