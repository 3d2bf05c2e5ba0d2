// tools/stages/table.h: the stages that there are, by the names of their tools.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "run/exit_status.h"
#include "stages/stage.h"

namespace pliant {

/// The names of all stages, in the order of a usual step.
std::vector<std::string> stage_names();

/// A new stage, to which nothing has been said yet; null where there is none of this name.
std::unique_ptr<Stage> make_stage(const std::string& name);

/// Wrong usage of a stage, and the number of the word that is to blame; 0, the name, where no single one is.
class StageUsageError : public UsageError {
 public:
  StageUsageError(const std::string& text, std::size_t word) : UsageError(text), word_(word) {}
  std::size_t word() const { return word_; }

 private:
  std::size_t word_;
};

/// A stage that is ready to run, from the words of a command line: the name of its tool, then options.
/// Throws      StageUsageError for what the tool would refuse, and for INPUT and the options that all tools have, which
///             a stage has not
std::unique_ptr<Stage> parse_stage(const std::vector<std::string>& words);

}  // namespace pliant
