// lib/pliant/evolve/schedule.h: at which times the steps of a simulation end, and which of them are frames.
#pragma once
#include <optional>
#include <vector>

namespace pliant {

struct ScheduleOptions {
  double dt = 0;                ///< the length of a step (time), above zero
  std::optional<double> until;  ///< the time at which all ends; the last step is shortened to meet it
  std::optional<long> steps;    ///< how many steps there are at most
  long every = 0;               ///< each so manieth step ends in a frame; 0: none does for this reason
  std::vector<double> at;       ///< times at which there is a frame; a step is cut in two to meet one
  bool even_steps = true;       ///< all steps but cut ones have the length dt
};

/// The times t0 + j dt of a simulation that begins at t0. They are counted from t0, so that the rounding errors of sums
/// do not pile up, and so that the time of a mesh alone tells what comes next: a simulation can go on from any frame.
/// Two times closer than 1e-9 dt are the same; round times are kept round (`round_time`).
class Schedule {
 public:
  /// Requires    dt > 0 and finite, times finite, steps and every not negative
  Schedule(double first_time, ScheduleOptions options);

  double first_time() const { return first_; }
  const ScheduleOptions& options() const { return options_; }

  /// The whole steps between t0 and `time`; only for even steps.
  long steps_done(double time) const;
  /// The end of the simulation, where it is known beforehand: `until`, or of even steps the last.
  std::optional<double> end() const;
  /// Where the part of a step that begins at `time` must end: a whole step further, or at a frame before; nothing if
  /// all is done. `longest` is how long a step may be if steps are not even.
  std::optional<double> next_goal(double time, long steps_done, double longest) const;
  /// Does a step, not only a part of one, end at `time`?
  bool ends_step(double time) const;
  /// Is there a frame at `time`, by the schedule: the first one, or one of `every` or of `at`? (The last state is also
  /// written, but a longer simulation would not have that frame.)
  bool is_frame(double time, long steps_done) const;
  /// Does `time`, or the number of steps, lie beyond the end, so that nothing is to be done that would lead there?
  bool is_past_end(double time, long steps_done) const;
  /// Is a simulation of another schedule, with the same first time, dt and every, at `time` in the state in which one
  /// of this schedule is then, on the way to the same goal, and were there frames at the same times before? For uneven
  /// steps false also where that is not known, since the step that led to `time` may have been shortened.
  bool agrees(const Schedule& other, double time, long steps_done) const;
  /// Are the times in `at` the same up to `time`?
  bool has_same_frames(const Schedule& other, double time) const;

 private:
  double slack() const;                         // times closer than this are the same
  double grid_time(long step) const;            // t0 + step dt, not beyond `until`
  double meet(double goal, double time) const;  // the next of `at` and `until` before `goal`, or in its place
  // The first goal of even steps that is not before `time`; none where all is done before.
  std::optional<double> goal_from(double time) const;

  double first_;
  ScheduleOptions options_;
};

}  // namespace pliant
