// tools/run/history.h: --history, by which a tool adds itself to the history of its document.
#pragma once
#include <string>
#include <vector>

#include "pliant/boundary/extra_members.h"
#include "run/tool_options.h"

namespace pliant {

/// Adds the flag, under another name where a tool has an option of this one.
void add_history_flag(CLI::App& app, ToolOptions& options, const std::string& name = "--history");

/// The options of a command line that decide the result, in the order of --help: all that were given, except those that
/// only say where to read and write or what to tell, and except what stands without a name (the input). Call it once
/// they are parsed.
std::vector<std::string> options_that_count(const CLI::App& app);

/// What `record` would refuse, for a tool that works long on a document with these members, or whose result takes the
/// history from them.
///
/// Throws      as `record`
void require_recordable(const ToolOptions& options, const ExtraMembers& extra);

/// Adds the tool with its options to the history of the document with these members, if --history is given.
///
/// Throws      InputError if the document has a member `history` of another kind; UsageError for an option that
///             is not UTF-8, which the name of a file need not be
void record(const ToolOptions& options, ExtraMembers& extra);

}  // namespace pliant
