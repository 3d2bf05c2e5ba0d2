// tools/run/progress_line.h: on a terminal, one line that tells how far a long run has come.
#pragma once
#include <memory>
#include <mutex>
#include <string>

#include "pliant/mesh/progress.h"
#include "run/tool_options.h"

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

  /// From now on a bar for the part done, and these words, instead of counters; a part below 0 is not known.
  void show(double part, const std::string& words);

  /// Erases the line, if one lives in this process, and keeps it away as long as the lock is held, so that a message
  /// can be written.
  static std::unique_lock<std::mutex> give_way();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pliant
