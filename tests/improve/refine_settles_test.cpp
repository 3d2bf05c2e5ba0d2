// tests/improve/refine_settles_test.cpp: refining what was refined does nothing, and what is left has reasons.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "improve/improve_meshes.h"
#include "pliant/improve/refine.h"
#include "pliant/improve/triangle_budget.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

/// How many seeds are tried: as many as PLIANT_SETTLE_SEEDS says, or as many as CI has time for.
int seed_count() {
  const char* text = std::getenv("PLIANT_SETTLE_SEEDS");
#ifdef NDEBUG
  return text != nullptr ? std::atoi(text) : 12;
#else
  return text != nullptr ? std::atoi(text) : 2;
#endif
}

/// Random goals: a least angle from 15 to 33 degrees, and perhaps bounds on area, size and turning.
QualityGoals random_refine_goals(const Mesh& mesh, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  QualityGoals goals;
  goals.min_angle = 15 + 18 * uniform(random);
  goals.keeps_thin = random() % 4 == 0;
  if (random() % 2) goals.max_area = area_of(mesh) / (20 + 200 * uniform(random));
  if (random() % 3 == 0)
    goals.size = [middle = mesh.point(0), size = mesh.size()](const Point& p, double) {
      return 0.03 * size + 0.3 * distance(p, middle);
    };
  if (random() % 3 == 0) goals.max_turning = 0.2 + uniform(random);
  return goals;
}

}  // namespace

TEST_CASE("refining a refined mesh does nothing, and every element left has a reason and a place",
          "[improve][property]") {
  const int degree = GENERATE(1, 2, 3, 4);
  for (int seed = 0; seed < seed_count(); ++seed)
    for (const Sample& sample : boundaries(degree)) {
      CAPTURE(degree, seed, sample.name);
      std::mt19937_64 random(static_cast<std::uint64_t>(1000 * degree + seed));
      Mesh mesh = mesh_of(sample.boundary, degree, seed % 2 == 1);
      RandomOperations(mesh, static_cast<std::uint64_t>(seed)).run(20);
      mesh.compact();
      RefineOptions options;
      options.goals = random_refine_goals(mesh, random);
      CAPTURE(options.goals->min_angle, options.goals->max_area);
      const PassReport first = refine(mesh, options);
      const std::string text = text_of(mesh);
      long reasons = 0;
      for (const auto& [reason, times] : first.refusals)
        if (!reason.starts_with("flip: ")) reasons += times;
      CHECK(static_cast<double>(reasons) == value_of(first, "left"));
      Mesh again(read_mesh(text));
      const PassReport second = refine(again, options);
      CHECK(value_of(second, "insertions") == 0);
      const bool is_same = text_of(again) == text;
      CHECK(is_same);
    }
}

TEST_CASE("goals that need more triangles than allowed are refused, beforehand or on the way", "[improve]") {
  const Mesh mesh = mesh_of(samples::interface(2), 2);
  const double area = area_of(mesh);
  RefineOptions options;
  options.goals.emplace();
  options.max_triangles = 1000;
  SECTION("by area, beforehand") { options.goals->max_area = area / 1001; }
  SECTION("by the area of one face, beforehand") {
    options.goals->face_area.assign(mesh.boundary().faces.size(), HUGE_VAL);
    options.goals->face_area.front() = 1e-12 * area;
  }
  SECTION("by size, beforehand") {
    options.goals->size = [](const Point&, double) { return 1e-9; };
  }
  SECTION("by turning, beforehand") { options.goals->max_turning = 1e-6; }
  SECTION("on the way") { options.goals->max_area = area / 700; }
  Mesh refined = mesh;
  CHECK_THROWS_AS(refine(refined, options), TooManyTriangles);
}

TEST_CASE("a mesh that has more triangles than allowed is passed on where nothing goes in", "[improve]") {
  BoundaryComplex lens = samples::with_faces({"lens"});
  lens.vertices = {{0, 0}, {1, 0}};
  lens.curves.push_back(samples::open_curve(lens, "lower", 0, 1, {{0.5, -1e-4}}, 0));
  lens.curves.push_back(samples::open_curve(lens, "upper", 1, 0, {{0.5, 1e-4}}, 0));
  Mesh mesh = mesh_of(lens, 2);
  REQUIRE(value_of(refine(mesh, {}), "left") > 0);
  RefineOptions options;
  options.max_triangles = 1;
  const PassReport report = refine(mesh, options);
  CHECK(value_of(report, "insertions") == 0);
  CHECK(mesh.triangle_count() > 1);
}

TEST_CASE("no refined mesh has fewer triangles than least_triangles says", "[improve][property]") {
  const int degree = GENERATE(1, 2, 3);
  for (const Sample& sample : boundaries(degree)) {
    CAPTURE(degree, sample.name);
    std::mt19937_64 random(5);
    for (int k = 0; k < 5; ++k) {
      Mesh mesh = mesh_of(sample.boundary, degree);
      RefineOptions options;
      options.goals = random_refine_goals(mesh, random);
      const double least = least_triangles(mesh, *options.goals).triangles;
      CAPTURE(k, least);
      const PassReport report = refine(mesh, options);
      if (value_of(report, "left") == 0) CHECK(mesh.triangle_count() >= least);
    }
  }
}
