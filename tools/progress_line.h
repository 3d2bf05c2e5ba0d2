// tools/progress_line.h: on a terminal, one line that tells how far a long run has come.
#pragma once
#include <memory>
#include <mutex>

#include "filter.h"
#include "pliant/improve/sizing.h"
#include "pliant/mesh/progress.h"

namespace pliant {

/// While it lives, a thread of its own shows the counters on standard error: only on a terminal, not with -q, after one
/// second, ten times a second at most, no wider than the terminal, and erased before anything else is said and at the
/// end. One at a time.
class ProgressLine {
 public:
  explicit ProgressLine(const ToolOptions& options);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// For the passes; null where nothing is shown.
  Progress* counters();
  /// A stage that counts nothing.
  void stage(const char* name);
  /// From now on this many frames of a series are done.
  void frames_done(long count);

  /// The one that lives, or null.
  static ProgressLine* shown();
  /// Erases the line, if there is one, and keeps it away as long as the lock is held, so that a message can be written.
  static std::unique_lock<std::mutex> give_way();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Starts the stage "refine" of the line that is shown, with an estimate of the points that these goals ask for (none
/// where only shapes matter). Returns the counters, or null.
Progress* start_refinement(const Mesh& mesh, const QualityGoals& goals);

}  // namespace pliant
