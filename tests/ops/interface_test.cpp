// tests/ops/interface_test.cpp: operations on a cell in a square of fluid, with an interface and a curve with corners.
#include <catch2/catch.hpp>
#include <random>

#include "ops/random_operations.h"
#include "pliant/boundary/check_boundary.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/star.h"
#include "support/sample_boundaries.h"

using namespace pliant;

namespace {

constexpr FaceId fluid = 0, cell = 1;

/// A square with `spans` spans on each side. It is one open curve, which starts and ends at one corner and has the
/// other three as knots of full multiplicity. In its middle is a cell with `around` spans.
BoundaryComplex cell_in_square(int degree, int spans = 3, int around = 10) {
  BoundaryComplex b = samples::with_faces({"fluid", "cell"});
  b.vertices = {{-2, -2}};
  const std::array<Point, 5> corners{Point{-2, -2}, {2, -2}, {2, 2}, {-2, 2}, {-2, -2}};
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  std::vector<Point> points{corners[0]};
  for (int side = 0; side < 4; ++side) {
    const Point a = corners[static_cast<std::size_t>(side)], d = corners[static_cast<std::size_t>(side) + 1] - a;
    for (int k = 1; k <= spans * degree; ++k) points.push_back(a + (double(k) / (spans * degree)) * d);
    points.back() = corners[static_cast<std::size_t>(side) + 1];
    for (int k = 1; k <= spans; ++k)
      knots.insert(knots.end(), static_cast<std::size_t>(degree), side + double(k) / spans);
  }
  knots.push_back(knots.back());
  Curve wall = samples::closed_curve("wall", BSpline(degree, false, knots, points), fluid);
  wall.start = wall.end = 0;
  b.curves.push_back(std::move(wall));
  b.curves.push_back(samples::closed_curve("membrane", samples::circle(degree, {0.1, -0.2}, 1, around), cell, fluid));
  return b;
}

/// The linear function that field 0 is everywhere, and those that the field by face is on either side.
double smooth_part(const Point& p) { return p.x + 2 * p.y - 3; }
double part_of(FaceId f, const Point& p) { return f == cell ? 5 - p.x + 3 * p.y : 2 * p.x - p.y; }

/// The mesh with three fields. Field 0 is linear, field 1 noise. Field 2 is by face: its first component is linear on
/// either side, the second one noise.
Mesh carried_interface(int degree) {
  const BoundaryComplex boundary = cell_in_square(degree);
  for (const Fault& fault : check_boundary(boundary)) FAIL(fault.place << ": " << fault.text);
  Mesh mesh;
  const GenerateOutcome outcome = mesh_from_boundary(boundary, {degree}, mesh);
  if (!outcome.ok) FAIL(outcome.failure);
  MeshData data = mesh.to_data();
  samples::add_field(data, "linear", 1, [](const Point& p) { return std::vector<double>{smooth_part(p)}; });
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> noise(-1, 1);
  samples::add_field(data, "noise", 1, [&](const Point&) { return std::vector<double>{noise(random)}; });
  Field jump;
  jump.name = "jump";
  jump.components = 2;
  jump.by_face = true;
  const auto n = static_cast<std::size_t>(net_size(degree));
  for (std::size_t k = 0; k < data.triangles.size(); ++k)
    jump.places.push_back({data.triangles[k], data.triangle_faces[k / n]});
  std::sort(jump.places.begin(), jump.places.end());
  jump.places.erase(std::unique(jump.places.begin(), jump.places.end()), jump.places.end());
  for (const auto& [p, f] : jump.places) {
    jump.values.push_back(part_of(f, data.points[static_cast<std::size_t>(p)]));
    jump.values.push_back(noise(random));
  }
  data.fields.push_back(std::move(jump));
  return Mesh(std::move(data));
}

void check_everything(const Mesh& mesh, double tolerance) {
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.invariant << " " << fault.place << ": " << fault.text);
  REQUIRE(find_invalid(mesh).empty());
  double worst = 0, worst_jump = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    for (const PointId p : mesh.net(t)) {
      const auto value = [&](int field) {
        return mesh.fields()[static_cast<std::size_t>(field)]
            .values[static_cast<std::size_t>(mesh.value_index(field, p, mesh.face(t)))];
      };
      worst = std::max(worst, std::abs(value(0) - smooth_part(mesh.point(p))));
      worst_jump = std::max(worst_jump, std::abs(value(2) - part_of(mesh.face(t), mesh.point(p))));
    }
  }
  CHECK(worst < tolerance);
  CHECK(worst_jump < tolerance);
}

/// The vertices inside a curve, ascending.
std::vector<PointId> curve_vertices(const Mesh& mesh, CurveId curve) {
  std::vector<PointId> vertices;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    for (int e = 0; e < 3; ++e) {
      const ConstraintId c = mesh.constraint(half_edge(t, e));
      if (c != none && mesh.constraint_curve(c) == curve) vertices.push_back(mesh.constraint_first(c));
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

TEST_CASE("random operations on both sides of an interface, and on it, keep every invariant", "[ops][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const std::uint64_t seed = GENERATE(range<std::uint64_t>(0, 3));
  CAPTURE(degree, seed);
  Mesh mesh = carried_interface(degree);
  check_everything(mesh, 1e-12);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.2, 0.8);
  int splits = 0, removals = 0, others = 0;
  const int most = mesh.triangle_count() + 80;
  for (int block = 0; block < 12; ++block) {
    CAPTURE(block);
    for (int k = 0; k < 60; ++k) {
      TriangleId t;
      do t = static_cast<TriangleId>(random() % static_cast<unsigned>(mesh.triangle_slots()));
      while (!mesh.is_alive(t));
      const HalfEdgeId h = half_edge(t, static_cast<int>(random() % 3));
      const bool grow = mesh.triangle_count() < most;
      const bool watch = k % 8 == 0;
      const MeshData before = watch ? mesh.to_data() : MeshData{};
      bool done = false;
      switch (random() % 8) {
        case 0:
          others += done = grow && insert_point(mesh, t, {0.3, 0.45, 0.25}).outcome == Outcome::done;
          break;
        case 1: {
          const HalfEdgeId on = half_edge(t, 0);
          const HalfEdgeId edge = mesh.is_constrained(on) ? on : mesh.is_constrained(next(on)) ? next(on) : h;
          splits += done = grow && split_edge(mesh, edge, uniform(random)).outcome == Outcome::done;
          break;
        }
        case 2:
        case 3:
          others += done = flip_edge(mesh, h) == Outcome::done;
          break;
        case 4:
          others += done = remove_inner_vertex(mesh, mesh.origin(h)) == Outcome::done;
          break;
        case 5:
        case 6: {
          Star star;
          find_star(mesh, mesh.origin(h), star);
          const CurveTolerance tolerance{HUGE_VAL, 0.03, random() % 2 == 0};
          if (is_on_curve(mesh, star))
            removals += done = remove_curve_vertex(mesh, mesh.origin(h), tolerance).outcome == Outcome::done;
          break;
        }
        default:
          others += done = smooth_edge(mesh, h, SmoothGoal::improve) == Outcome::done;
      }
      if (watch && !done) REQUIRE(same_document(before, mesh.to_data()));
    }
    check_everything(mesh, 1e-10);
    const MeshData data = mesh.to_data();
    Mesh again(data);
    mesh.compact();
    CHECK(same_document(data, mesh.to_data()));
    CHECK(same_document(data, again.to_data()));
  }
  CHECK(splits > 15);
  CHECK(removals > 3);
  CHECK(others > 60);
}

TEST_CASE("splits of an interface that are undone give back the fields of both faces", "[ops]") {
  const int degree = GENERATE(1, 2, 3, 4);
  CAPTURE(degree);
  Mesh mesh = carried_interface(degree);
  const Mesh before = mesh;
  int on_interface = 0;
  for (const HalfEdgeId h : before.half_edges()) {
    if (!mesh.is_constrained(h)) continue;
    on_interface += mesh.twin(h) != none;
    const InsertResult inserted = split_edge(mesh, h, 0.375);
    REQUIRE(inserted.outcome == Outcome::done);
    REQUIRE(remove_curve_vertex(mesh, inserted.vertex, {1e-10}).outcome == Outcome::done);
    mesh.compact();
  }
  CHECK(on_interface >= 20);
  check_everything(mesh, 1e-11);
  REQUIRE(mesh.triangle_count() == before.triangle_count());
  CHECK(difference_of_functions(before, mesh, 400) < 1e-9);
}

TEST_CASE("any break of a closed curve can be removed, the first one too, with or without keeping the area", "[ops]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const bool keep_area = GENERATE(false, true);
  CAPTURE(degree, keep_area);
  const Mesh whole(carried_disk(degree, false, 24));
  const double area = whole.spline(0).area();
  std::vector<double> errors;
  for (const PointId v : curve_vertices(whole, 0)) {
    Mesh mesh = whole;
    const CurveRemoval removal = remove_curve_vertex(mesh, v, {1.0, 1.0, keep_area});
    CAPTURE(v, describe(removal.outcome));
    errors.push_back(removal.error);
    if (removal.outcome != Outcome::done) continue;
    for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.invariant << " " << fault.place << ": " << fault.text);
    if (keep_area) CHECK(mesh.spline(0).area() == Approx(area).epsilon(1e-8));
  }
  REQUIRE(errors.size() == 24);
  // The curve looks the same from every break, so all errors are equal.
  for (const double error : errors) CHECK(error == Approx(errors[5]).epsilon(1e-6));
}

TEST_CASE("operations go on at a cusp, where det J may be zero", "[ops]") {
  const BoundaryComplex boundary = samples::crescent(0);
  Mesh mesh;
  const GenerateOutcome outcome = mesh_from_boundary(boundary, {3}, mesh);
  REQUIRE(outcome.ok);
  REQUIRE(mesh.boundary().cusps.size() == 1);
  const Point cusp = mesh.boundary().vertices[static_cast<std::size_t>(mesh.boundary().cusps[0])];
  const auto at_cusp = [&](HalfEdgeId h) { return mesh.is_constrained(h) && mesh.point(mesh.origin(h)) == cusp; };
  int splits = 0, inserts = 0;
  for (int round = 0; round < 3; ++round)
    for (const HalfEdgeId h : mesh.half_edges()) {
      if (!at_cusp(h)) continue;
      splits += split_edge(mesh, h, 0.4).outcome == Outcome::done;
      inserts += insert_point(mesh, triangle_of(h), {0.3, 0.4, 0.3}).outcome == Outcome::done;
      smooth_edge(mesh, next(h), SmoothGoal::improve);
      break;
    }
  CHECK(splits == 3);
  CHECK(inserts == 3);
  for (const Fault& fault : check_mesh(mesh)) FAIL_CHECK(fault.invariant << " " << fault.place << ": " << fault.text);
  CHECK(find_invalid(mesh).empty());
}
