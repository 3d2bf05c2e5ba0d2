// tools/evolve/evolve_options.h: the options of evolve, read and checked.
#pragma once
#include <string>
#include <vector>

#include "pliant/evolve/schedule.h"
#include "run/tool_options.h"

namespace CLI {
class App;
}

namespace pliant {

struct EvolveOptions {
  ToolOptions tool;
  std::string step_text;     ///< STEP, or what stands in the file of --step
  ScheduleOptions schedule;  ///< all but dt
  double courant = 0;        ///< --cfl; 0: steps are even
  double steady = 0;         ///< --until-steady; 0: it is not asked
  std::string frames;        ///< --frames; empty: a series goes to -o
  std::string log, history;
  bool resumes = false, prints_pipe = false;

  bool is_numbered() const { return !frames.empty(); }
  /// The options that decide which frames there are, for comparing two commands.
  std::string frame_options() const;
  /// The options that decide where the end is, but for --steps, which are whole ones whatever their number.
  std::string end_options() const;
};

/// " --option value", the value with all its digits.
std::string word_pair(const std::string& option, double value);

/// Reads the command line: `add` its options, parse, `read` them.
class EvolveCommand {
 public:
  void add(CLI::App& app);
  ToolOptions& tool_options() { return options_.tool; }
  /// Throws      UsageError; std::system_error where the file of --step cannot be read
  EvolveOptions read(const CLI::App& app);

 private:
  void read_step(const CLI::App& app);
  void read_goals(const CLI::App& app);
  void read_times();
  void read_frames(const CLI::App& app);
  /// Keeps what the history tells: the step, and those of the given options that no resumed run may change.
  void tell_history(std::vector<std::string>& given) const;
  void read_logs();

  EvolveOptions options_;
  std::string step_, step_file_, until_, steps_, every_, at_, cfl_, steady_;
};

}  // namespace pliant
