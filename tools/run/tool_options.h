// tools/run/tool_options.h: the options that mean the same in every tool, and what a tool says on standard error.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pliant {

/// The options that mean the same everywhere. "-" is standard input or output.
struct ToolOptions {
  std::string tool;                ///< the tool's name, for messages
  std::string input = "-";         ///< [INPUT]
  std::string output = "-";        ///< -o, --output
  std::string report;              ///< --report; empty: none
  bool quiet = false;              ///< -q, --quiet
  bool verbose = false;            ///< -v, --verbose
  bool history = false;            ///< --history
  std::vector<std::string> given;  ///< with --history, the options that decide the result
  bool takes_msh = false;          ///< set by tools whose `for_each_mesh` also reads Gmsh's MSH files
};

/// Adds [INPUT], -o, -q, -v, --version and, for tools that write documents, --report and --history.
void add_common_options(CLI::App& app, ToolOptions& options, bool writes_documents = true);

/// "TOOL: text" on standard error, unless -q: what was done, and what was left out.
void say(const ToolOptions& options, const std::string& text);
/// The same in spite of -q: what makes the exit status another than 0.
void say_failure(const ToolOptions& options, const std::string& text);
/// With -v, what an exporter has written: how many meshes with how many elements in all, and bytes.
void say_written(const ToolOptions& options, std::size_t meshes, std::size_t triangles, std::size_t bytes);

}  // namespace pliant
