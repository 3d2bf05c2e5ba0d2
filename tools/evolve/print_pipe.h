// tools/evolve/print_pipe.h: the shell loop of tools that a command of evolve equals.
#pragma once
#include <string>

#include "evolve/evolve_options.h"
#include "evolve/step.h"

namespace pliant {

/// A bash script that writes the frames of the command.   Throws UsageError for what a loop of tools cannot do
std::string pipe_of(const EvolveOptions& options, const Step& step);

}  // namespace pliant
