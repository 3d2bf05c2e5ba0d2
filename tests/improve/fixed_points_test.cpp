// tests/improve/fixed_points_test.cpp: coarsen and refine, one after the other, come to rest.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>

#include "improve/improve_meshes.h"
#include "pliant/flow/advect.h"
#include "pliant/improve/coarsen.h"
#include "pliant/improve/refine.h"

using namespace pliant;
using namespace pliant::improve_meshes;

namespace {

struct RandomCase {
  Mesh mesh;
  CoarsenOptions coarse;
  RefineOptions fine;
  std::string text;  ///< describes the case
};

/// Draws a boundary, a degree, goals, and how the mesh was refined and moved before.
RandomCase random_case(int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<>()(random);
  };
  const auto chance = [&](double share) { return uniform(0, 1) < share; };
  RandomCase drawn;
  const int degree = 1 + static_cast<int>(uniform(0, 4));
  const std::vector<Sample> all = boundaries(degree);
  const Sample& sample = all[static_cast<std::size_t>(uniform(0, static_cast<double>(all.size())))];
  drawn.mesh = mesh_of(sample.boundary, degree);
  QualityGoals goals;
  goals.min_angle = uniform(15, 33);
  const double area = area_of(drawn.mesh);
  if (chance(0.6)) goals.max_area = area / uniform(5, 60);
  const double length = std::sqrt(area) / uniform(2, 8), slope = uniform(0, 0.3);
  if (chance(0.4)) goals.size = [=](const Point& p, double) { return length + slope * std::fabs(p.x - 0.3); };
  if (chance(0.4)) goals.max_turning = uniform(20, 90) * std::numbers::pi / 180;
  drawn.coarse.goals = drawn.fine.goals = goals;
  drawn.coarse.tolerance = std::exp(uniform(std::log(1e-4), std::log(0.03))) * drawn.mesh.size();
  drawn.coarse.step_tolerance = uniform(0.1, 1) * *drawn.coarse.tolerance;
  if (chance(0.7)) {  // refined more than the goals ask for
    RefineOptions finer = drawn.fine;
    finer.goals->max_area = std::min(goals.max_area, area / 20) / uniform(1, 6);
    refine(drawn.mesh, finer);
  }
  const int steps = chance(0.5) ? static_cast<int>(uniform(1, 4)) : 0;
  const double rate = uniform(0.5, 3) / drawn.mesh.size(), shear = uniform(-0.3, 0.3);
  for (int step = 0; step < steps; ++step) {
    AdvectOptions options;
    options.dt = 1;
    options.policy = StepPolicy::limit;
    advect(
        drawn.mesh,
        [&](const Point& p, double) {
          return Vector{0.05 / rate * std::sin(rate * p.y) + shear * p.y, 0.05 / rate * std::cos(rate * p.x)};
        },
        options);
  }
  drawn.text = sample.name + ", degree " + std::to_string(degree) + ", " + std::to_string(drawn.mesh.triangle_count()) +
               " triangles, angle " + std::to_string(goals.min_angle) + ", " + std::to_string(steps) + " steps";
  return drawn;
}

/// Coarsens and refines three times: the removals and insertions of each round.
std::array<std::array<long, 2>, 3> three_rounds(RandomCase& drawn) {
  std::array<std::array<long, 2>, 3> done{};
  for (auto& [removals, insertions] : done) {
    removals = std::lround(value_of(coarsen(drawn.mesh, drawn.coarse), "removals"));
    insertions = std::lround(value_of(refine(drawn.mesh, drawn.fine), "insertions"));
  }
  return done;
}

void check_rest(int first, int last) {
  for (int seed = first; seed < last; ++seed) {
    RandomCase drawn = random_case(seed);
    const auto done = three_rounds(drawn);
    CAPTURE(seed, drawn.text, done[0], done[1], done[2]);
    CHECK(done[2] == std::array<long, 2>{0, 0});
    CHECK(check_structure(drawn.mesh.to_data()).empty());
  }
}

}  // namespace

TEST_CASE("vertices stay whose removal would let refine succeed on what it had left", "[improve]") {
  // This mesh once had three removals and three insertions in every round, beside two triangles that refine had left.
  std::ifstream file(PLIANT_SAMPLES "/../tests/improve/chase.json");
  REQUIRE(file);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  RandomCase chase;
  chase.mesh = Mesh(read_mesh(text));
  QualityGoals goals = goals_of(chase.mesh, [](const Point& p, double) { return 0.4203 + 0.2 * std::fabs(p.x - 0.3); });
  chase.coarse.goals = chase.fine.goals = goals;
  chase.coarse.tolerance = 1e-3 * chase.mesh.size();
  chase.coarse.step_tolerance = 0.1 * *chase.coarse.tolerance;
  refine(chase.mesh, chase.fine);
  CHECK(value_of(refine(chase.mesh, chase.fine), "insertions") == 0);
  for (int round = 0; round < 2; ++round) {
    coarsen(chase.mesh, chase.coarse);
    CHECK(value_of(refine(chase.mesh, chase.fine), "insertions") == 0);
  }
  CHECK(three_rounds(chase)[2] == std::array<long, 2>{0, 0});
}

TEST_CASE("coarsen and refine come to rest: the third round does nothing", "[improve][property]") { check_rest(0, 60); }

TEST_CASE("coarsen and refine come to rest on two thousand meshes", "[.long]") {
  const char* const first = std::getenv("PLIANT_FIRST_SEED");
  const char* const last = std::getenv("PLIANT_LAST_SEED");
  check_rest(first ? std::atoi(first) : 0, last ? std::atoi(last) : 2000);
}
