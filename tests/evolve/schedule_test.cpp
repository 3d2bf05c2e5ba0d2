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

Schedule ended(ScheduleOptions options, std::optional<double> until) {
  options.until = until;
  return {0, std::move(options)};
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

TEST_CASE("schedules with different ends agree up to where a step was shortened", "[evolve]") {
  ScheduleOptions options = steps_of(0.1);
  options.every = 2;
  const auto until = [&options](std::optional<double> end) { return ended(options, end); };
  const Schedule longer = until(2), endless = until({});
  for (const double end : {0.55, 0.3 + 1e-12, 0.3 - 1e-12}) {
    CAPTURE(end);
    CHECK_FALSE(longer.agrees(until(end), end, 3));  // also where it differs from a whole step by less than the slack
    CHECK_FALSE(endless.agrees(until(end), end, 3));
    CHECK(longer.agrees(until(end), 0.2, 2));
    CHECK(longer.agrees(until(end), 0.15, 1));  // a part of a step that neither shortens
    CHECK(until(end).agrees(until(end), end, 3));
  }
  CHECK(longer.agrees(until(0.3), 0.3, 3));
  CHECK_FALSE(longer.agrees(until(0.55), 0.53, 5));  // a part of the step that one shortens
  CHECK(longer.agrees(until(0.6), 0.53, 5));
  CHECK(longer.agrees(until(-1), 0, 0));
  CHECK_FALSE(longer.agrees(until(0.2), 0.4, 4));  // beyond an end no schedule leads
  CHECK(endless.agrees(endless, 1e300, 4));        // nor does any step to so late a time
}

TEST_CASE("schedules agree as long as the times of their frames are the same", "[evolve]") {
  ScheduleOptions options = steps_of(0.1);
  const auto at = [&options](std::vector<double> times) {
    ScheduleOptions cut = options;
    cut.at = std::move(times);
    return Schedule(0, cut);
  };
  const Schedule one = at({0.25, 0.5});
  CHECK(one.agrees(at({0.25, 0.5, 0.75}), 0.7, 7));
  CHECK_FALSE(one.agrees(at({0.25, 0.5, 0.75}), 0.75, 7));
  CHECK_FALSE(one.agrees(at({0.25, 0.5, 0.75}), 0.8, 8));
  CHECK_FALSE(one.agrees(at({0.25, 0.5, 0.75}), 0.73, 7));  // a part of the step that is cut
  CHECK(one.agrees(at({-3, 0, 0.25, 0.5}), 1, 10));         // before the beginning there is no frame
  CHECK(one.agrees(at({0.25}), 0.4, 4));
  CHECK_FALSE(one.agrees(at({0.25}), 0.5, 5));
  CHECK_FALSE(one.has_same_frames(at({0.25}), 0.5));
  CHECK_FALSE(one.agrees(at({0.5}), 0.5, 5));
  CHECK_FALSE(at({}).agrees(at({0.3 + 1e-13}), 0.3, 3));
}

TEST_CASE("uneven steps agree where none can have been shortened", "[evolve]") {
  ScheduleOptions options = steps_of(0.1);
  options.even_steps = false;
  options.every = 2;
  const auto until = [&options](std::optional<double> end) { return ended(options, end); };
  CHECK(until(2).agrees(until(1), 0.85, 33));
  CHECK(until(2).agrees(until(1), 0.95, 34));        // a frame that both have
  CHECK_FALSE(until(2).agrees(until(1), 0.95, 33));  // a part of a step to the end, or not
  CHECK_FALSE(until(2).agrees(until(1), 1, 34));
  CHECK(until(1).agrees(until(1), 0.95, 33));
  CHECK(until(1).agrees(until(1), 1, 33));
}

TEST_CASE("where two schedules agree, one goes on as the other does", "[evolve][property]") {
  std::mt19937 random(8);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  int agreed = 0, differed = 0;
  for (int round = 0; round < 500; ++round) {
    CAPTURE(round);
    ScheduleOptions options = steps_of(round % 2 == 0 ? uniform(0.001, 1) : 1.0 / (1 + round));
    const double start = round % 3 == 0 ? 0 : uniform(-10, 10);
    const auto some_end = [&] {
      const double steps = uniform(0, 30);
      return start + options.dt * (round % 4 == 0 ? std::floor(steps) + uniform(-2e-9, 2e-9) : steps);
    };
    const auto with_end = [&](double end) {
      ScheduleOptions ended = options;
      ended.until = end;
      if (round % 5 == 0)
        for (int k = 0; k < 3; ++k) ended.at.push_back(start + options.dt * std::floor(uniform(0, 30)) / 2);
      return Schedule(start, ended);
    };
    const double first_end = some_end(), second_end = some_end();
    const Schedule one = with_end(std::min(first_end, second_end)), other = with_end(std::max(first_end, second_end));
    const std::vector<double> ones = goals_of(one), others = goals_of(other);
    for (std::size_t k = 0; k < ones.size(); ++k) {
      const bool same = k < others.size() && std::equal(ones.begin(), ones.begin() + long(k) + 1, others.begin());
      const bool frames_are_same = one.has_same_frames(other, ones[k]);
      CHECK(other.agrees(one, ones[k], 0) == (same && frames_are_same));
      (same ? agreed : differed) += 1;
    }
  }
  CHECK(agreed > 1000);
  CHECK(differed > 100);
}

TEST_CASE("a time lies past the end where no step to it is due", "[evolve]") {
  ScheduleOptions options = steps_of(0.1);
  options.until = 0.3;
  CHECK_FALSE(Schedule(0, options).is_past_end(0.3 + 1e-12, 3));
  CHECK(Schedule(0, options).is_past_end(0.31, 3));
  CHECK(Schedule(1, options).is_past_end(1, 0));
  options.until.reset();
  options.steps = 3;
  CHECK_FALSE(Schedule(1, options).is_past_end(1.3, 3));
  CHECK(Schedule(1, options).is_past_end(1.35, 3));
  options.even_steps = false;
  CHECK_FALSE(Schedule(1, options).is_past_end(9, 3));
  CHECK(Schedule(1, options).is_past_end(1.2, 4));
}
