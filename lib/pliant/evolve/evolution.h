// lib/pliant/evolve/evolution.h: a simulation as the repetition of one step, a sequence of passes (paper §6).
#pragma once
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "pliant/evolve/schedule.h"
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"

namespace pliant {

/// One pass of a step.
struct StepPass {
  std::string name;
  bool advances_time = false;  ///< it moves the mesh from mesh.time on, no further than `until`; others keep the time
  /// Throws whatever it likes; that comes out of `Evolution::advance`.
  std::function<PassReport(Mesh& mesh, double until)> run;
};

/// What one run of the passes has done.
struct StepRecord {
  struct Work {
    PassReport report;
    double seconds = 0;
  };
  long step = 0;           ///< the number of the step, from 1
  int part = 1;            ///< the run within this step, from 1: above 1 where the step could only be taken in parts
  double time = 0;         ///< after the run
  double dt = 0;           ///< from the time before
  bool ends_step = true;   ///< false: the rest of the step comes next
  std::vector<Work> work;  ///< one for each pass
};

/// A step that cannot be finished: the text names the time and what blocks. The mesh is valid, and as far as it came.
class StepBlocked : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct EvolutionOptions {
  ScheduleOptions schedule;
  int most_parts = 20;       ///< so many parts of one step are tried
  double least_part = 1e-6;  ///< a part of a step that is smaller is no progress
  /// How long the next step may be, for steps that are not even; infinite: as long as `schedule.dt`.
  std::function<double(const Mesh&)> longest_step = [](const Mesh&) { return std::numeric_limits<double>::infinity(); };
};

/// A simulation: a mesh, and the passes of a step that is repeated until all is done. Where the pass that moves time on
/// can only take a part of the step (`advect` with StepPolicy::limit), the other passes repair the mesh and the rest of
/// the step follows. All that decides what comes next is in the mesh, its time, and for uneven steps their number.
///
///     Evolution evolution(mesh, mesh.time, {{"advect", true, move}, {"flipdelaunay", false, flip}}, {schedule});
///     while (!evolution.is_done()) evolution.advance();
class Evolution {
 public:
  /// A simulation that began at `first_time` and has come to mesh.time. `steps_done` counts only where steps are not
  /// even. The mesh must live as long as this.
  /// Requires    exactly one of the passes advances time
  Evolution(Mesh& mesh, double first_time, std::vector<StepPass> passes, EvolutionOptions options, long steps_done = 0);

  const Schedule& schedule() const { return schedule_; }
  bool is_done() const;
  /// The steps that are finished.
  long steps_done() const;
  /// Is the mesh, as it is now, a frame by the schedule?
  bool is_frame() const { return schedule_.is_frame(mesh_.time, steps_done()); }
  /// Runs all passes once: a whole step, or as much of one as can be taken.
  /// Requires    !is_done()
  /// Throws      StepBlocked where the time has so many digits that a step does not change it, where most_parts runs
  /// did not finish a step, or one brought it less than least_part
  ///             further; what the passes throw
  StepRecord advance();

 private:
  void require_progress(const StepRecord& record, const PassReport& moved);

  Mesh& mesh_;
  std::vector<StepPass> passes_;
  EvolutionOptions options_;
  Schedule schedule_;
  long counted_steps_;  // where steps are not even
  int part_ = 0;        // of the step that is under way
};

}  // namespace pliant
