// tools/run/history.h: --history, by which a tool adds itself to the history of its document.
#pragma once
#include <string>
#include <vector>

#include "pliant/boundary/extra_members.h"
#include "run/tool_options.h"

namespace pliant {

/// Adds the flag, under another name where a tool has an option of this one.
void add_history_flag(CLI::App& app, ToolOptions& options, const std::string& name = "--history");

/// The options of a command line by which the result is what it is: all that were given, in the order of --help, but
/// those that say only where to read and write and what to tell, and but what stands without a name (the input). Call
/// it once they are parsed.
std::vector<std::string> options_that_count(const CLI::App& app);

/// What `record` would refuse, for a tool that works long on a document with these members, or whose result takes the
/// history from them.
///
/// Throws      as `record`
void require_recordable(const ToolOptions& options, const ExtraMembers& extra);

/// Adds the tool with its options to the history of the document with these members, if --history is given.
///
/// Throws      InputError if the document has a member `history` of another kind
void record(const ToolOptions& options, ExtraMembers& extra);

}  // namespace pliant
