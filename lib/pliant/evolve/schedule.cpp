// lib/pliant/evolve/schedule.cpp: steps are numbered from the first time, so that the time alone tells where one is.
#include "pliant/evolve/schedule.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "pliant/flow/advect_to.h"

namespace pliant {
namespace {

constexpr double same_time = 1e-9;   // times closer than this part of a step are the same
constexpr double most_steps = 9e15;  // beyond it not every whole number is a double

}  // namespace

Schedule::Schedule(double first_time, ScheduleOptions options) : first_(first_time), options_(std::move(options)) {
  assert(options_.dt > 0 && std::isfinite(options_.dt) && std::isfinite(first_));
  std::ranges::sort(options_.at);
  options_.at.erase(std::unique(options_.at.begin(), options_.at.end()), options_.at.end());
}

double Schedule::slack() const { return same_time * options_.dt; }

double Schedule::grid_time(long step) const {
  const double time = round_time(first_ + static_cast<double>(step) * options_.dt, options_.dt);
  return options_.until && time >= *options_.until - slack() ? std::max(*options_.until, first_) : time;
}

long Schedule::steps_done(double time) const {
  const double quotient = std::floor((time - first_) / options_.dt);
  if (quotient >= most_steps) return static_cast<long>(most_steps);
  long step = static_cast<long>(std::max(quotient, 0.0));
  while (step > 0 && grid_time(step) > time + slack()) --step;
  // The last step may be a short one, to `until`.
  while (grid_time(step + 1) <= time + slack() && grid_time(step + 1) > grid_time(step)) ++step;
  return step;
}

std::optional<double> Schedule::end() const {
  if (options_.steps && options_.even_steps) return grid_time(*options_.steps);
  return options_.until;
}

double Schedule::meet(double goal, double time) const {
  const auto next = std::ranges::upper_bound(options_.at, time + slack());
  if (next != options_.at.end() && *next <= goal + slack()) goal = *next;
  if (options_.until && goal >= *options_.until - slack()) goal = *options_.until;
  return goal;
}

std::optional<double> Schedule::next_goal(double time, long steps_done, double longest) const {
  if (options_.until && time >= *options_.until - slack()) return {};
  if (options_.steps && steps_done >= *options_.steps) return {};
  const double goal = options_.even_steps ? grid_time(steps_done + 1) : time + std::min(longest, options_.dt);
  return meet(goal, time);
}

bool Schedule::ends_step(double time) const {
  return !options_.even_steps || std::abs(grid_time(steps_done(time)) - time) <= slack();
}

bool Schedule::is_frame(double time, long steps_done) const {
  if (time == first_) return true;
  if (std::ranges::binary_search(options_.at, time)) return true;
  if (options_.every == 0 || steps_done % options_.every != 0) return false;
  if (!options_.even_steps) return true;
  const double goal = round_time(first_ + static_cast<double>(steps_done) * options_.dt, options_.dt);
  return std::abs(goal - time) <= slack();  // a last step that was shortened to `until` is none
}

bool Schedule::is_past_end(double time, long steps_done) const {
  if (options_.until && time > *options_.until + slack()) return true;
  if (!options_.steps) return false;
  return options_.even_steps ? time > grid_time(*options_.steps) + slack() : steps_done > *options_.steps;
}

std::optional<double> Schedule::goal_from(double time) const {
  if (time <= first_) return first_;
  if ((time - first_) / options_.dt >= most_steps) return {};
  // One whole step before is a goal, or as good as one: a goal close to it leads to the same next one.
  double goal = grid_time(std::max(0L, steps_done(time) - 1));
  while (goal < time) {
    if (options_.until && goal >= *options_.until - slack()) return {};
    const double next = meet(grid_time(steps_done(goal) + 1), goal);
    if (!(next > goal)) return {};  // a step does not change a time of so many digits
    goal = next;
  }
  return goal;
}

bool Schedule::has_same_frames(const Schedule& other, double time) const {
  const auto up_to = [this, time](const std::vector<double>& at) {
    const auto begin = std::ranges::upper_bound(at, first_ + slack());
    return std::vector<double>(begin, std::max(begin, std::ranges::upper_bound(at, time)));
  };
  return up_to(options_.at) == up_to(other.options_.at);
}

bool Schedule::agrees(const Schedule& other, double time, long steps_done) const {
  assert(first_ == other.first_ && options_.dt == other.options_.dt && options_.every == other.options_.every &&
         options_.even_steps == other.options_.even_steps);
  if (time == first_) return true;
  if (!has_same_frames(other, time)) return false;
  if (options_.even_steps) return goal_from(time) == other.goal_from(time);
  constexpr double never = std::numeric_limits<double>::infinity();
  const bool has_same_end = options_.until == other.options_.until;
  const double end =
      has_same_end ? never : std::min(options_.until.value_or(never), other.options_.until.value_or(never));
  const double reach = time + options_.dt + slack();  // a part of a step that ends at `time` went no further than this
  return (end > reach && has_same_frames(other, reach)) || (end > time + slack() && is_frame(time, steps_done));
}

}  // namespace pliant
