// tools/run/documents.h: the documents of the input, one after the other, and faults with their places.
#pragma once
#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "formats/document/recognize.h"
#include "pliant/boundary/boundary_complex.h"
#include "pliant/mesh/mesh_data.h"
#include "run/doubts.h"
#include "run/frame.h"
#include "run/tool_options.h"

namespace pliant {
struct MshImport;
struct MshOptions;

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

struct InputCloser {
  void operator()(std::FILE* file) const;  ///< not standard input
};
using InputFile = std::unique_ptr<std::FILE, InputCloser>;
/// Opens a file to read it; "-" is standard input.   Throws      std::system_error with the path
InputFile open_input(const std::string& path);

/// Calls `use` with every document of the input, or up to the first one for which it returns false. What it throws
/// comes out as a Placed, but for UsageError and std::system_error. A file that begins as MSH files do goes to
/// `use_msh_file`, if there is one, as a whole.
void for_each_document(const ToolOptions& options, FileKind kind, const std::function<bool(InputDocument&)>& use,
                       const std::function<void(std::string_view bytes, const Frame&)>& use_msh_file = {});

/// Calls `use` with every mesh of the input, one at a time. What `use` throws gets the place of the document: an
/// InputError comes out with "FILE:LINE: frame N: /pointer: TEXT (column N)", of CBOR with "FILE: frame N: /pointer:
/// TEXT (byte N)"; a NoResult with "FILE: frame N: ". An MSH file, known by its first bytes, is one frame; what it
/// lacks is said on standard error.
/// Throws      Placed for all of these and for an empty input; UsageError as `use` does; InputError for compressed
///             bytes that are damaged; std::system_error where the input cannot be read
void for_each_mesh(const ToolOptions& options, const std::function<void(MeshData&&, const Frame&)>& use);
/// The same; `use` calls `forget_text` once no check is to come that may blame a single number.
void for_each_mesh(const ToolOptions& options,
                   const std::function<void(MeshData&&, const Frame&, const std::function<void()>& forget_text)>& use);
/// The same up to the first mesh for which `take` returns true. What follows it is not read, so that a fault there is
/// not found, and a program that writes it into a pipe may be ended by SIGPIPE.
void find_mesh(const ToolOptions& options, const std::function<bool(MeshData&&, const Frame&)>& take);
/// As for_each_mesh, with boundary documents.
void for_each_boundary(const ToolOptions& options, const std::function<void(BoundaryComplex&&, const Frame&)>& use);

/// Calls `use` with the MSH file that the input is; what was left out of it is said on standard error. Errors as above,
/// without a frame.
void for_msh(const ToolOptions& options, const MshOptions& msh,
             const std::function<void(MshImport&&, const Frame&)>& use);

}  // namespace pliant
