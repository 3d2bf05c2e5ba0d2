// tools/run/run_tool.h: from the command line to messages and an exit status.
#pragma once
#include <functional>

#include "run/tool_options.h"

namespace pliant {

/// Parses, runs `body`, and turns what it throws into a message on standard error and an exit status: UsageError 2,
/// InputError 3, NoResult, domain_error and what memory does not hold 4, system_error 5, all else 6. --help and
/// --version give 0, parse errors 2. `body` returns the status itself where nothing is thrown. A closed pipe ends the
/// process by SIGPIPE.
int run_tool(CLI::App& app, int argc, char** argv, ToolOptions& options, const std::function<int()>& body);

}  // namespace pliant
