// tools/stages/table.h: the stages that there are, by the names of their tools.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "stages/stage.h"

namespace pliant {

/// The names of all stages, in the order of a usual step.
std::vector<std::string> stage_names();

/// A new stage, to which nothing has been said yet; null where there is none of this name.
std::unique_ptr<Stage> make_stage(const std::string& name);

/// A stage that is ready to run, from the words of a command line: the name of its tool, then options.
/// Throws      UsageError for what the tool would refuse, and for INPUT and the options that all tools have, which a
///             stage has not
std::unique_ptr<Stage> parse_stage(const std::vector<std::string>& words);

}  // namespace pliant
