// tests/evolve/schedule_test.cpp: goals are counted from the first time, and the time alone tells what comes next.
#include "pliant/evolve/schedule.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace pliant;

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

ScheduleOptions steps_of(double dt) {
  ScheduleOptions options;
  options.dt = dt;
  return options;
}

/// The times at which parts of steps end, from the first on, at most so many.
std::vector<double> goals_of(const Schedule& schedule, std::size_t most = 10000) {
  std::vector<double> goals;
  double time = schedule.first_time();
  while (goals.size() < most) {
    const std::optional<double> goal = schedule.next_goal(time, schedule.steps_done(time), unbounded);
    if (!goal) break;
    REQUIRE(*goal > time);
    goals.push_back(time = *goal);
  }
  return goals;
}

}  // namespace

TEST_CASE("steps of a round length end at round times, however many they are", "[evolve]") {
  ScheduleOptions options = steps_of(0.01);
  options.until = 8;
  const Schedule schedule(0, options);
  const std::vector<double> goals = goals_of(schedule);
  REQUIRE(goals.size() == 800);
  CHECK(goals[28] == 0.29);  // the 29 is a number that 29 * 0.01 misses
  CHECK(goals[699] == 7);
  CHECK(goals.back() == 8);
  CHECK(*schedule.end() == 8);
}

TEST_CASE("goals are t0 + j dt to rounding, where no time is round", "[evolve]") {
  const double start = 0.12345678901234567, dt = 1.0 / 3;
  ScheduleOptions options = steps_of(dt);
  options.steps = 1000;
  const std::vector<double> goals = goals_of(Schedule(start, options));
  REQUIRE(goals.size() == 1000);
  for (std::size_t j = 0; j < goals.size(); ++j) CHECK(std::abs(goals[j] - (start + double(j + 1) * dt)) < 1e-12);
}

TEST_CASE("a step that would miss the end by less than 1e-9 of it is the last one", "[evolve]") {
  const auto [dt, until, steps] = GENERATE(table<double, double, std::size_t>({{0.1, 0.3, 3},
                                                                               {0.1, 0.3 + 1e-12, 3},
                                                                               {0.1, 0.25, 3},
                                                                               {0.1, 0.300001, 4},
                                                                               {5, 1, 1},
                                                                               {0.3, 0, 0},
                                                                               {0.3, -1, 0}}));
  ScheduleOptions options = steps_of(dt);
  options.until = until;
  const Schedule schedule(0, options);
  const std::vector<double> goals = goals_of(schedule);
  CAPTURE(dt, until);
  REQUIRE(goals.size() == steps);
  if (steps > 0) CHECK(goals.back() == until);
}

TEST_CASE("a step is cut in two at a frame, and the next ones end where they would have", "[evolve]") {
  ScheduleOptions options = steps_of(0.1);
  options.steps = 4;
  options.at = {0.25, 0.1, 0.3 + 1e-13, 7};
  const Schedule schedule(0, options);
  CHECK(goals_of(schedule) == std::vector<double>{0.1, 0.2, 0.25, 0.3 + 1e-13, 0.4});
  CHECK(schedule.is_frame(0.25, 2));
  CHECK_FALSE(schedule.is_frame(0.2, 2));
  CHECK(schedule.is_frame(0.1, 1));
  CHECK(schedule.is_frame(0.3 + 1e-13, 3));
  CHECK_FALSE(schedule.ends_step(0.25));
  CHECK(schedule.ends_step(0.2));
}

TEST_CASE("each so manieth step is a frame; a last step that was shortened is none", "[evolve]") {
  ScheduleOptions options = steps_of(0.1);
  options.every = 2;
  options.until = 0.55;
  const Schedule schedule(0, options);
  std::vector<double> frames;
  for (const double time : goals_of(schedule))
    if (schedule.is_frame(time, schedule.steps_done(time))) frames.push_back(time);
  CHECK(frames == std::vector<double>{0.2, 0.4});
  CHECK(schedule.is_frame(0, 0));
}

TEST_CASE("from any time on, whatever happened before, goals and frames are the same", "[evolve][property]") {
  std::mt19937 random(3);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  for (int round = 0; round < 300; ++round) {
    ScheduleOptions options = steps_of(round % 2 == 0 ? uniform(0.001, 1) : 1.0 / (1 + round));
    const double start = round % 3 == 0 ? 0 : uniform(-10, 10);
    options.until = start + options.dt * uniform(0, 60);
    if (round % 5 == 0)
      for (int k = 0; k < 5; ++k) options.at.push_back(uniform(start, *options.until));
    else
      options.every = 1 + round % 7;
    const Schedule schedule(start, options);
    const std::vector<double> goals = goals_of(schedule);
    for (std::size_t k = 0; k + 1 < goals.size(); ++k) {
      // Stopped between two goals, the simulation goes on to the same next one.
      const double between = goals[k] + uniform(0.01, 0.99) * (goals[k + 1] - goals[k]);
      CHECK(schedule.next_goal(between, schedule.steps_done(between), unbounded) == goals[k + 1]);
      CHECK(schedule.steps_done(between) == schedule.steps_done(goals[k]));
    }
    if (!goals.empty()) CHECK(goals.back() == *options.until);
  }
}

TEST_CASE("a longer simulation has the frames of a shorter one, but for its last", "[evolve]") {
  ScheduleOptions options = steps_of(0.07);
  options.every = 3;
  options.until = 1;
  const Schedule shorter(0, options);
  options.until = 2;
  const Schedule longer(0, options);
  std::vector<double> few, many;
  for (const double time : goals_of(shorter))
    if (shorter.is_frame(time, shorter.steps_done(time))) few.push_back(time);
  for (const double time : goals_of(longer))
    if (longer.is_frame(time, longer.steps_done(time))) many.push_back(time);
  REQUIRE(few.size() == 4);
  many.resize(few.size());
  CHECK(few == many);
  // Its last state is the middle of a step of the longer one, which goes on to that step's end.
  CHECK_FALSE(longer.is_frame(1, longer.steps_done(1)));
  CHECK(*longer.next_goal(1, longer.steps_done(1), unbounded) == Approx(1.05).epsilon(1e-14));
}

TEST_CASE("uneven steps are as long as they may be, and meet frames and the end", "[evolve]") {
  ScheduleOptions options = steps_of(0.1);
  options.even_steps = false;
  options.until = 1;
  options.every = 2;
  const Schedule schedule(0, options);
  CHECK(*schedule.next_goal(0.5, 7, 0.03) == 0.53);
  CHECK(*schedule.next_goal(0.5, 7, 3) == 0.6);
  CHECK(*schedule.next_goal(0.95, 7, 3) == 1);
  CHECK_FALSE(schedule.next_goal(1, 9, 3));
  CHECK(schedule.is_frame(0.53, 8));
  CHECK_FALSE(schedule.is_frame(0.56, 9));
}
