// tools/run/tool_options.cpp: the options that mean the same in every tool, and what a tool says on standard error.
#include "run/tool_options.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "completion/completion.h"
#include "run/history.h"
#include "run/progress_line.h"

namespace pliant {

void add_common_options(CLI::App& app, ToolOptions& options, bool writes_documents) {
  options.tool = app.get_name();
  app.add_option("INPUT", options.input, "a file, or - for standard input")->capture_default_str();
  app.add_option("-o,--output", options.output, "write to this file, whole or not at all")->type_name("FILE");
  if (writes_documents) {
    app.add_option("--report", options.report, "write what was done to this file, a line of JSON a frame")
        ->type_name("FILE");
    add_history_flag(app, options);
  }
  auto* quiet =
      app.add_flag("-q,--quiet", options.quiet, "no progress, no summary, no warnings; errors are said all the same");
  app.add_flag("-v,--verbose", options.verbose, "say what was done")->excludes(quiet);
  if (app.get_version_ptr() == nullptr)  // else the tool has more to say
    app.set_version_flag("--version", app.get_name() + " (Pliant) " PLIANT_VERSION);
  add_completion(app);
}

void add_form_option(CLI::App& app, ToolOptions& options) {
  app.add_option("--to", options.to, "the form of the documents that are written; by default that of the input")
      ->check(CLI::IsMember({"cbor", "json"}));
}

void say(const ToolOptions& options, const std::string& text) {
  if (!options.quiet) say_failure(options, text);
}

void say_failure(const ToolOptions& options, const std::string& text) {
  const auto quiet_line = ProgressLine::give_way();
  std::fprintf(stderr, "%s: %s\n", options.tool.c_str(), text.c_str());
}

void say_written(const ToolOptions& options, std::size_t meshes, std::size_t triangles, std::size_t bytes) {
  if (!options.verbose) return;
  say(options, std::to_string(triangles) + " triangles" +
                   (meshes == 1 ? "" : " in " + std::to_string(meshes) + " meshes") + ", " + std::to_string(bytes) +
                   " bytes");
}

}  // namespace pliant
