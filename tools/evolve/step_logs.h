// tools/evolve/step_logs.h: --log and --history, a line for each run of the step, which a later run continues.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "formats/report/evolve_log.h"
#include "run/growing_file.h"

namespace pliant {

class StepLogs {
 public:
  /// Paths may be empty: then nothing is written.
  StepLogs(std::string log, std::string history) : log_path_(std::move(log)), history_path_(std::move(history)) {}
  bool is_wanted() const { return !log_path_.empty() || !history_path_.empty(); }

  /// For a simulation that begins: old files are replaced when the first line is written.
  void create();
  /// For one that goes on: finds what stays, which is all that is complete up to `time`; changes nothing.
  /// Returns the files that end before that time, so that steps are missing.
  /// Throws      InputError where a file is none of ours; std::system_error
  std::vector<std::string> find_kept(double time, double first_time);
  /// Cuts off the rest, after `find_kept`. Files that are not there are new.   Throws std::system_error
  void reopen();
  /// Throws      std::system_error
  void add(const StepLine& line);
  /// A simulation without a step has empty files.
  void finish();

 private:
  std::string log_path_, history_path_;
  std::optional<GrowingFile> log_, history_;
  std::int64_t kept_log_ = 0, kept_history_ = 0;  // bytes
  std::vector<std::string> columns_;              // of the history; none before its first line
};

}  // namespace pliant
