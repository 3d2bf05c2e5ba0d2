// tools/run/history.cpp: --history, by which a tool adds itself to the history of its document.
#include "run/history.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "formats/document/characters.h"
#include "formats/document/history.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

/// Options that leave a document as it is, in all tools.
constexpr std::array<std::string_view, 13> silent_options{
    "--output", "--quiet",  "--verbose", "--report", "--history",   "--add-history", "--to",
    "--frames", "--resume", "--log",     "--csv",    "--lines-csv", "--print-pipe"};

void collect(const CLI::App& app, std::vector<std::string>& out) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0 || option->get_positional()) continue;
    const std::string name =
        option->get_lnames().empty() ? "-" + option->get_snames().front() : "--" + option->get_lnames().front();
    if (std::ranges::find(silent_options, name) != silent_options.end()) continue;
    if (option->get_items_expected_max() == 0) {
      out.push_back(name);
      continue;
    }
    for (const std::string& value : option->results()) {
      out.push_back(name);
      out.push_back(value);
    }
  }
  for (const CLI::App* group : app.get_subcommands([](const CLI::App* sub) { return sub->get_name().empty(); }))
    collect(*group, out);
}

}  // namespace

void add_history_flag(CLI::App& app, ToolOptions& options, const std::string& name) {
  app.add_flag(name, options.history, "add this tool and its options to the history that the document carries");
}

std::vector<std::string> options_that_count(const CLI::App& app) {
  std::vector<std::string> out;
  collect(app, out);
  return out;
}

void require_recordable(const ToolOptions& options, const ExtraMembers& extra) {
  if (options.history) require_history(extra);
}

void record(const ToolOptions& options, ExtraMembers& extra) {
  if (!options.history) return;
  for (const std::string& text : options.given)
    if (find_no_utf8(text) != nullptr) throw UsageError("the history takes UTF-8 only, and '" + text + "' is not");
  add_history(extra, {options.tool, PLIANT_VERSION, options.given});
}

}  // namespace pliant
