// tools/evolve/step_logs.h: --log and --history, a line for each run of the step, which a later run continues.
#pragma once
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
  /// For one that goes on: cuts off what came after `time`, or was half written. Files that are not there are new.
  /// Returns the files that end before that time, so that steps are missing.
  /// Throws      InputError where a file is none of ours
  std::vector<std::string> reopen(double time, double first_time);
  /// Throws      std::system_error
  void add(const StepLine& line);
  /// A simulation without a step has empty files.
  void finish();

 private:
  std::string log_path_, history_path_;
  std::optional<GrowingFile> log_, history_;
  std::vector<std::string> columns_;  // of the history; none before its first line
};

}  // namespace pliant
