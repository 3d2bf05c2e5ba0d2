// tests/improve/refine_test.cpp: refined meshes meet their goals, or count what is left, and keep what they carry.
#include "pliant/improve/refine.h"

#include <catch2/catch.hpp>

#include "improve/improve_meshes.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

/// The angle by which the control polygon of an edge turns, leg by leg.
double turning(const Mesh& mesh, HalfEdgeId h) {
  double sum = 0;
  for (int k = 1; k < mesh.degree(); ++k) {
    const Vector a = mesh.point(mesh.edge_point(h, k)) - mesh.point(mesh.edge_point(h, k - 1));
    const Vector b = mesh.point(mesh.edge_point(h, k + 1)) - mesh.point(mesh.edge_point(h, k));
    sum += std::abs(std::atan2(cross(a, b), dot(a, b)));
  }
  return sum;
}

/// How many elements miss the goals after each goal was made easier by a factor (below 1: harder).
int count_missing(const Mesh& mesh, const QualityGoals& goals, double easier) {
  int count = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    bool misses = least_angle(mesh, t) * easier < goals.min_angle;
    misses = misses || area_at(mesh, t) > easier * goals.area_bound(mesh.face(t));
    Point middle;
    double longest = 0;
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e);
      middle += mesh.point(mesh.origin(h)) / 3;
      longest = std::max(longest, distance(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h))));
      misses = misses || (mesh.is_constrained(h) && turning(mesh, h) > easier * goals.max_turning);
    }
    misses = misses || (goals.size && longest > easier * 1.5 * goals.size(middle, mesh.time));
    count += misses;
  }
  return count;
}

struct Goals {
  const char* name;
  QualityGoals goals;
};
std::vector<Goals> kinds_of_goals(const Mesh& mesh) {
  const double area = area_of(mesh);
  std::vector<Goals> all(6);
  all[0].name = "angle";
  all[1].name = "a greater angle";
  all[1].goals.min_angle = 28;
  all[2].name = "area";
  all[2].goals.max_area = area / 150;
  all[3].name = "area of one face";
  all[3].goals.face_area.assign(mesh.boundary().faces.size(), HUGE_VAL);
  all[3].goals.face_area.back() = area / 400;
  all[4].name = "size";
  all[4].goals.size = [middle = mesh.point(0), size = mesh.size()](const Point& p, double) {
    return 0.02 * size + 0.2 * distance(p, middle);
  };
  all[5].name = "turning, any angle";
  all[5].goals.min_angle = 0;
  all[5].goals.max_turning = 0.15;
  return all;
}

}  // namespace

TEST_CASE("every element meets the goals, or is counted as left", "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  for (const Sample& sample : boundaries(degree)) {
    const Mesh first = mesh_of(sample.boundary, degree);
    for (const Goals& kind : kinds_of_goals(first)) {
      CAPTURE(degree, sample.name, kind.name);
      Mesh mesh = first;
      RefineOptions options;
      options.goals = kind.goals;
      const PassReport report = refine(mesh, options);
      check_left(mesh);
      const double left = value_of(report, "left");
      for (const auto& [reason, times] : report.refusals) UNSCOPED_INFO(times << " times " << reason);
      CHECK(left >= count_missing(mesh, kind.goals, 1 + 1e-9));
      CHECK(left <= count_missing(mesh, kind.goals, 1 - 1e-9));
      // But for the crescent no boundary has a small angle, so that every element can be made good.
      if (kind.goals.min_angle <= 20.7 && sample.name != "crescent") CHECK(left == 0);
      CHECK(left <= 0.05 * mesh.triangle_count());
    }
  }
}

TEST_CASE("refinement keeps curves, area, linear functions and integrals", "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  const bool by_face = GENERATE(false, true);
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, sample.name, by_face);
    Mesh mesh = mesh_of(sample.boundary, degree, by_face);
    const Mesh before = mesh;
    RefineOptions options;
    options.goals.emplace();
    options.goals->max_area = area_of(mesh) / 100;
    refine(mesh, options);
    REQUIRE(mesh.triangle_count() > before.triangle_count());
    for (CurveId c = 0; c < static_cast<CurveId>(mesh.boundary().curves.size()); ++c) {
      const BSpline &was = before.spline(c), &now = mesh.spline(c);
      CHECK(now.first_parameter() == was.first_parameter());
      CHECK(now.period() == was.period());
      double off = 0;
      for (int k = 0; k <= 200; ++k) {
        const double t = was.first_parameter() + was.period() * k / 200;
        off = std::max(off, distance(was.evaluate(t), now.evaluate(t)));
      }
      CHECK(off < 1e-14 * 10 * mesh.size());
      CHECK(mesh.boundary().curves[static_cast<std::size_t>(c)].removal_error == 0);
    }
    CHECK(area_of(mesh) == Approx(area_of(before)).epsilon(1e-13));
    CHECK(linear_error(mesh) < 1e-12);
    for (const int component : {0, 1})
      CHECK(integral_of(mesh, 1, component) ==
            Approx(integral_of(before, 1, component)).margin(1e-12 * std::max(1.0, area_of(before))));
  }
}

TEST_CASE("a mesh that was refined is left as it is", "[improve]") {
  const int degree = GENERATE(1, 2, 3);
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, sample.name);
    Mesh mesh = mesh_of(sample.boundary, degree);
    RefineOptions options;
    options.goals.emplace();
    options.goals->max_area = area_of(mesh) / 60;
    if (value_of(refine(mesh, options), "left") > 0) continue;
    const std::string text = text_of(mesh);
    CHECK(value_of(refine(mesh, options), "insertions") == 0);
    const bool is_same = text_of(mesh) == text;
    CHECK(is_same);
  }
}

TEST_CASE("no more points are inserted than allowed, and none much closer than the least size", "[improve]") {
  const int degree = GENERATE(1, 2, 3);
  Mesh mesh = mesh_of(samples::interface(degree), degree);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = 1e-4;
  options.max_insertions = 37;
  CHECK(value_of(refine(mesh, options), "insertions") == 37);
  check_left(mesh);

  options.max_insertions = 1'000'000;
  options.goals->min_size = 0.05;
  const auto shortest_chord = [](const Mesh& m) {
    double least = HUGE_VAL;
    for (const HalfEdgeId h : m.half_edges())
      least = std::min(least, distance(m.point(m.origin(h)), m.point(m.target(h))));
    return least;
  };
  Mesh coarse = mesh_of(samples::interface(degree), degree);
  const double before = shortest_chord(coarse);
  refine(coarse, options);
  check_left(coarse);
  CHECK(shortest_chord(coarse) >= 0.9 * std::min(before, 0.05));
}

TEST_CASE("refinement ends at small angles of the boundary, even at a cusp", "[improve]") {
  const double height = GENERATE(0.3, 0.01, 0.0);
  CAPTURE(height);
  BoundaryComplex boundary = samples::crescent(height);
  if (height == 0) boundary.cusps = {0};
  Mesh mesh = mesh_of(boundary, 3);
  RefineOptions options;
  options.goals.emplace();
  options.goals->max_area = area_of(mesh) / 100;
  const PassReport report = refine(mesh, options);
  check_left(mesh);
  CHECK(mesh.triangle_count() < 20000);
  CHECK(value_of(report, "left") < 0.2 * mesh.triangle_count());
}
