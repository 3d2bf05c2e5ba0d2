// tests/improve/quick_goals_test.cpp: the quick test of goals agrees with the whole one.
#include "pliant/improve/refining/quick_goals.h"

#include <numbers>

#include "improve/tangled_meshes.h"
#include "pliant/geometry/validity/jacobian.h"
#include "pliant/improve/refining/find_poor.h"
#include "pliant/mesh/turned_over.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

double area_of_element(const Mesh& mesh, TriangleId t) {
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  mesh.gather_points(t, net);
  return element_area(mesh.degree(), net);
}

/// Goals that some elements of the mesh meet and others miss.
QualityGoals random_goals(const Mesh& mesh, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto some = static_cast<TriangleId>(random() % static_cast<std::size_t>(mesh.triangle_count()));
  QualityGoals goals;
  goals.min_angle = random() % 4 == 0 ? 0 : 30 * uniform(random);
  if (random() % 3 != 0) goals.max_area = std::fabs(area_of_element(mesh, some)) * (random() % 2 == 0 ? 1 : 1.5);
  goals.face_area.assign(mesh.boundary().faces.size(), HUGE_VAL);
  if (random() % 3 == 0) goals.face_area.back() = std::fabs(area_of_element(mesh, some));
  if (random() % 3 != 0) goals.max_turning = 0.6 * uniform(random);
  if (random() % 8 == 0) goals.size = [](const Point& p, double) { return 0.1 + std::fabs(p.x); };
  goals.keeps_thin = random() % 4 == 0;
  return goals;
}

}  // namespace

TEST_CASE("the quick test of goals has the answers of the whole one", "[improve][property]") {
  const int degree = GENERATE(range(1, 5));
  std::mt19937_64 random(static_cast<std::uint64_t>(degree));
  std::uniform_real_distribution<double> noise(-1, 1);
  long met = 0, missed = 0;
  for (const Sample& sample : boundaries(degree)) {
    const Mesh straight = refined(sample, degree, 60);
    for (int trial = 0; trial < 20; ++trial) {
      const double push = (trial % 5) * 0.02 * straight.size() / 10;
      const double unit = std::ldexp(1, static_cast<int>(random() % 3) * 50 - 50);
      std::vector<Point> points;
      for (PointId p = 0; p < straight.point_slots(); ++p)
        points.push_back(unit * (straight.point(p) + push * Vector{noise(random), noise(random)}));
      Mesh mesh = straight;
      mesh.set_points(std::move(points));
      mesh.compact();
      const QualityGoals goals = random_goals(mesh, random);
      const QuickGoals quick(mesh, goals);
      std::vector<TriangleId> bad;
      for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
        CAPTURE(sample.name, degree, trial, t);
        const Attack whole = attack_on(mesh, t, goals), found = quick.attack_on(t);
        REQUIRE(found.reason == whole.reason);
        REQUIRE(found.excess == whole.excess);
        REQUIRE(found.edge == whole.edge);
        if (whole.reason || is_turned_over(mesh, t)) bad.push_back(t);
        ++(whole.reason ? missed : met);
        if (!quick.are_surely_met(t)) continue;
        REQUIRE(!is_turned_over(mesh, t));
        REQUIRE(area_of_element(mesh, t) <= goals.area_bound(mesh.face(t)));
      }
      CHECK(find_bad(mesh, goals) == bad);
    }
  }
  CHECK(met > 1000);
  CHECK(missed > 1000);
}

TEST_CASE("the quick test of goals decides nearly all elements that meet them", "[improve]") {
  const Mesh mesh = refined({"disk", samples::one_cell(2)}, 2, 500);
  QualityGoals goals;
  goals.max_area = 2 * area_of(mesh) / 500;
  goals.max_turning = 0.5;
  const QuickGoals quick(mesh, goals);
  int met = 0, quickly = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    met += attack_on(mesh, t, goals).reason == nullptr;
    quickly += quick.are_surely_met(t);
  }
  CHECK(met > 500);
  CHECK(quickly >= 0.99 * met);
}
