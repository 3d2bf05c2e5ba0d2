// tools/series.h: the documents of the input, one after the other, and faults with their places.
#pragma once
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "filter.h"
#include "formats/document/recognize.h"

namespace pliant {

/// What ends a tool, with an exit status, and the place of its document already in the text.
class Placed : public std::runtime_error {
 public:
  Placed(int status, const std::string& text) : std::runtime_error(text), status_(status) {}
  int status() const { return status_; }

 private:
  int status_;
};

inline constexpr std::string_view out_of_memory =
    "this needs more memory than there is; ask for fewer or larger elements (refine and bspline2mesh: --max-triangles)";

/// The words for an exception that nobody expects, which is a fault of the program (status 6).
std::string describe_internal_error(const std::string& text);

/// Calls `use` with the text of every document of the input. What it throws comes out as a Placed, but for UsageError
/// Calls `use` with the text of every document of the input. What it throws comes out as a Placed, but for UsageError
/// and std::system_error. A file that begins as MSH files do goes to `use_msh_file`, if there is one, as a whole.
void for_each_document(const ToolOptions& options, FileKind kind,
                       const std::function<void(std::string_view text, const Frame&)>& use,
                       const std::function<void(std::string_view bytes, const Frame&)>& use_msh_file = {});

}  // namespace pliant
