// tests/evolve/evolution_test.cpp: the loop over passes: parts of steps, what blocks, what passes throw.
#include "pliant/evolve/evolution.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "pliant/flow/advect_to.h"
#include "support/sample_meshes.h"

using namespace pliant;

namespace {

/// A pass that moves the time on, by no more than `most`.
StepPass mover(double most) {
  return {"move", true, [most](Mesh& mesh, double until) {
            mesh.time = std::min(mesh.time + most, until);
            PassReport report;
            report.notes.emplace_back("something is in the way");
            return report;
          }};
}

/// A pass that counts how often it runs.
StepPass counter(int& count) {
  return {"count", false, [&count](Mesh&, double) {
            ++count;
            return PassReport{};
          }};
}

EvolutionOptions until(double dt, double time) {
  EvolutionOptions options;
  options.schedule.dt = dt;
  options.schedule.until = time;
  return options;
}

}  // namespace

TEST_CASE("a step that is taken in parts is repaired after each, and ends at its goal", "[evolve]") {
  Mesh mesh(samples::disk(2));
  int repairs = 0;
  Evolution evolution(mesh, 0, {mover(0.04), counter(repairs)}, until(0.1, 0.2));
  std::vector<int> parts;
  std::vector<double> times;
  while (!evolution.is_done()) {
    const StepRecord record = evolution.advance();
    parts.push_back(record.part);
    times.push_back(record.time);
    CHECK(record.ends_step == (record.part == 3));
    CHECK(record.work.size() == 2);
    CHECK(record.dt > 0);
  }
  CHECK(parts == std::vector<int>{1, 2, 3, 1, 2, 3});
  CHECK(times[2] == 0.1);
  CHECK(times[5] == 0.2);
  CHECK(repairs == 6);
  CHECK(evolution.steps_done() == 2);
}

TEST_CASE("a step of too many or too small parts stops, with time and cause; the mesh is as far as it came",
          "[evolve]") {
  using Catch::Matchers::Contains;
  Mesh mesh(samples::disk(2));
  SECTION("too many") {
    Evolution evolution(mesh, 0, {mover(0.001)}, until(0.1, 1));
    for (int part = 1; part < 20; ++part) evolution.advance();
    CHECK_THROWS_WITH(evolution.advance(), Contains("at time 0.02") && Contains("20 parts") && Contains("in the way"));
    CHECK(mesh.time == Approx(0.02));
  }
  SECTION("too small") {
    Evolution evolution(mesh, 0, {mover(1e-8)}, until(0.1, 1));
    CHECK_THROWS_WITH(evolution.advance(), Contains("only 1e-08 of a step of 0.1") && Contains("in the way"));
  }
  SECTION("none") {
    Evolution evolution(mesh, 0, {mover(0)}, until(0.1, 1));
    CHECK_THROWS_AS(evolution.advance(), StepBlocked);
  }
}

TEST_CASE("a step that does not change the digits of the time stops at once", "[evolve]") {
  const auto [time, dt] = GENERATE(table<double, double>({{1e300, 0.1}, {1e9, 1e-12}, {-1e9, 1e-12}}));
  Mesh mesh(samples::disk(2));
  mesh.time = time;
  EvolutionOptions options;
  options.schedule.dt = dt;
  options.schedule.steps = 3;
  options.schedule.even_steps = GENERATE(true, false);
  Evolution evolution(mesh, time, {mover(1)}, options);
  REQUIRE_FALSE(evolution.is_done());
  CHECK_THROWS_WITH(evolution.advance(), Catch::Matchers::Contains("does not advance the time"));
  CHECK(mesh.time == time);
}

TEST_CASE("what a pass throws comes out, and later passes do not run", "[evolve]") {
  Mesh mesh(samples::disk(2));
  int later = 0;
  Evolution evolution(
      mesh, 0, {{"fail", true, [](Mesh&, double) -> PassReport { throw std::domain_error("no"); }}, counter(later)},
      until(0.1, 1));
  CHECK_THROWS_AS(evolution.advance(), std::domain_error);
  CHECK(later == 0);
}

TEST_CASE("an evolution that begins at any state of another one ends in the same states", "[evolve]") {
  const VelocityField flow = make_flow("rotation", {});
  const auto passes = [&flow] {
    return std::vector<StepPass>{{"advect", true, [&flow](Mesh& mesh, double goal) {
                                    AdvectOptions options;
                                    options.dt = 0.07;
                                    return advect_to(mesh, flow, options, goal).report;
                                  }}};
  };
  Mesh whole(samples::disk(3));
  Evolution all(whole, 0, passes(), until(0.07, 1));
  std::vector<std::vector<Point>> states;
  while (!all.is_done()) {
    all.advance();
    states.push_back(whole.to_data().points);
  }
  REQUIRE(states.size() == 15);
  Mesh half(samples::disk(3));
  Evolution first(half, 0, passes(), until(0.07, 1));
  for (int k = 0; k < 6; ++k) first.advance();
  Mesh rest(half.to_data());
  Evolution second(rest, 0, passes(), until(0.07, 1));
  CHECK(second.steps_done() == 6);
  while (!second.is_done()) second.advance();
  CHECK(rest.time == whole.time);
  CHECK(rest.to_data().points == states.back());
}

TEST_CASE("uneven steps are counted, and each is as long as the mesh allows", "[evolve]") {
  Mesh mesh(samples::disk(2));
  EvolutionOptions options = until(0.1, 1);
  options.schedule.even_steps = false;
  options.longest_step = [](const Mesh& now) { return now.time < 0.49 ? 0.05 : 0.2; };
  Evolution evolution(mesh, 0, {mover(1)}, options, 4);
  while (!evolution.is_done()) evolution.advance();
  CHECK(evolution.steps_done() == 4 + 10 + 5);
  CHECK(mesh.time == 1);
}
