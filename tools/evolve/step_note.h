// tools/evolve/step_note.h: the file beside the output that tells which step and which options have made the frames.
#pragma once
#include <optional>
#include <string>

#include "evolve/evolve_options.h"
#include "evolve/step.h"

namespace pliant {

/// Where the note stands.
std::string step_file(const EvolveOptions& options);
/// Notes which step makes the frames, for a later `read_note`, and when the flow was steady.   Throws std::system_error
void note_step(const EvolveOptions& options, const Step& step, std::optional<double> steady_at = {});
/// Removes the note of an earlier run, before another one begins to write.
void forget_step(const EvolveOptions& options);

/// What is noted of the run that made the frames.
struct EarlierRun {
  ScheduleOptions schedule;         ///< as now, but for `until` and `at`
  double steady = 0;                ///< its --until-steady
  std::optional<double> steady_at;  ///< the time at which it ended for that reason
};

/// Nothing if there is no note.
/// Throws      UsageError where an earlier run had another step, or options of which no frame can be kept
std::optional<EarlierRun> read_note(const EvolveOptions& options, const Step& step);
/// Ends with wrong usage: the options that choose frames are not those before.
[[noreturn]] void refuse_other_frames(const EvolveOptions& options);

}  // namespace pliant
