// tools/run/tool_options.h: the options that mean the same in every tool, and what a tool says on standard error.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "formats/document/document_form.h"

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
  std::string to;                  ///< --to; empty: as the input

  /// The form of the documents that are written, if those that are read have this form.
  DocumentForm output_form(DocumentForm as_input) const {
    if (to.empty()) return as_input;
    return to == "cbor" ? DocumentForm::cbor : DocumentForm::json;
  }
};

/// Adds [INPUT], -o, -q, -v, --version and, for tools that write documents, --report and --history.
void add_common_options(CLI::App& app, ToolOptions& options, bool writes_documents = true);

/// Adds --to, for tools that write documents.
void add_form_option(CLI::App& app, ToolOptions& options);

/// "TOOL: text" on standard error, unless -q: what was done, and what was left out.
void say(const ToolOptions& options, const std::string& text);
/// The same in spite of -q: what makes the exit status another than 0.
void say_failure(const ToolOptions& options, const std::string& text);
/// With -v, what an exporter has written: how many meshes with how many elements in all, and bytes.
void say_written(const ToolOptions& options, std::size_t meshes, std::size_t triangles, std::size_t bytes);

}  // namespace pliant
