// tools/filter.h: what all tools share: options, reading series, whole-or-nothing output, exit statuses.
#pragma once
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/report/pass_report_json.h"
#include "pliant/boundary/boundary_complex.h"
#include "pliant/boundary/fault.h"
#include "pliant/mesh/mesh.h"
#include "pliant/mesh/pass_report.h"

namespace CLI {
class App;
}

namespace pliant {
struct MshImport;
struct MshOptions;

/// Exit statuses of every tool.
namespace status {
inline constexpr int done = 0, check_failed = 1, wrong_usage = 2, bad_input = 3, no_result = 4, io_failed = 5,
                     internal_error = 6;
}

/// Wrong usage that the parser cannot see (status 2): options that exclude each other, a name that does not exist.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// No valid result (status 4): an unsafe step, contact, elements left invalid. The text says how far the tool came.
class NoResult : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A mesh that breaks what the tool needs (status 3), with every fault.
class BadMesh : public InputError {
 public:
  explicit BadMesh(std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// The options that mean the same everywhere. "-" is standard input or output.
struct ToolOptions {
  std::string tool;          ///< the tool's name, for messages
  std::string input = "-";   ///< [INPUT]
  std::string output = "-";  ///< -o, --output
  std::string report;        ///< --report; empty: none
  bool quiet = false;        ///< -q, --quiet
  bool verbose = false;      ///< -v, --verbose
  bool takes_msh = false;    ///< set by tools whose `for_each_mesh` also reads Gmsh's MSH files
};

/// Adds [INPUT], -o, -q, -v, -j, --version and (unless `with_report` is false) --report.
void add_common_options(CLI::App& app, ToolOptions& options, bool with_report = true);

/// Parses, runs `body`, and turns what it throws into a message on standard error and an exit status: UsageError 2,
/// InputError 3, NoResult, domain_error and what memory does not hold 4, system_error 5, all else 6. --help and
/// --version give 0, parse errors 2. `body` returns the status itself where nothing is thrown. A closed pipe ends the
/// process by SIGPIPE.
int run_tool(CLI::App& app, int argc, char** argv, ToolOptions& options, const std::function<int()>& body);

/// What is wrong with the arguments that the parser did not take, and the nearest option there is; `complaint` is what
/// the parser says, for all other faults.
std::string explain_usage(const CLI::App& app, const std::string& complaint);

/// "TOOL: text" on standard error, unless -q: what was done, and what was left out.
void say(const ToolOptions& options, const std::string& text);
/// The same in spite of -q: what makes the exit status another than 0.
void say_failure(const ToolOptions& options, const std::string& text);
/// With -v, what an exporter has written: how many meshes with how many elements in all, and bytes.
void say_written(const ToolOptions& options, std::size_t meshes, std::size_t triangles, std::size_t bytes);

/// One document of the input.
struct Frame {
  std::string source;  ///< the file's name, or "standard input"
  long index = 0;      ///< number in the series, from 0
  long line = 1;       ///< on which it starts
};

/// Calls `use` with every mesh of the input, one at a time. What `use` throws gets the place of the document: an
/// InputError comes out with "FILE:LINE: frame N: /pointer: TEXT (column N)", a NoResult with "FILE: frame N: ". With
/// `takes_msh` an MSH file, known by its first bytes, is one frame; what it lacks is said on standard error.
/// Throws      InputError also for an empty input; std::system_error where the input cannot be read
void for_each_mesh(const ToolOptions& options, const std::function<void(MeshData&&, const Frame&)>& use);
/// The same with boundary documents.
void for_each_boundary(const ToolOptions& options, const std::function<void(BoundaryComplex&&, const Frame&)>& use);

/// Calls `use` with the MSH file that the input is; what was left out of it is said on standard error. Errors as above,
/// without a frame.
void for_msh(const ToolOptions& options, const MshOptions& msh,
             const std::function<void(MshImport&&, const Frame&)>& use);

/// Runs `work` on a document whose lengths are in `unit` (normalize_unit). Where that is not 1, what it throws says so:
/// places and lengths in its text are those of the normalised document.
void in_unit(double unit, const std::function<void()>& work);
/// Brings what a pass reports back into the units of the document; of notes, which are texts, it says that they are
/// not.
void report_in_document(PassReport& report, double unit);
/// That sentence; empty for 1.
std::string explain_unit(double unit);

/// Throws BadMesh for the structural faults of the mesh and, unless it `accepts_tangled`, for its invalid elements.
void require_mesh(const MeshData& data, bool accepts_tangled);

/// The result of a tool: standard output, or a file that appears whole (`commit`) or not at all. An existing file that
/// is not a regular one (a device, a FIFO) is written in place.
class OutputFile {
 public:
  /// Opens a temporary file beside the target.   Throws std::system_error
  explicit OutputFile(const std::string& path);
  ~OutputFile();  ///< removes the temporary file unless committed
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Writes all of it, at once: it has left the process on return.
  void write(std::string_view bytes);
  /// Closes the file and gives it its name; nothing may be written after.
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Seconds since construction or the last lap.
class Stopwatch {
 public:
  double lap();

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Where --report goes (a JSON line a frame, complete at once) and what -v prints.
class FrameReports {
 public:
  explicit FrameReports(const ToolOptions& options);
  ~FrameReports();
  FrameReports(const FrameReports&) = delete;
  FrameReports& operator=(const FrameReports&) = delete;
  /// Does anybody want to know? If not, what goes into `quality` need not be measured.
  bool is_wanted() const;
  /// `seconds` names the parts of the work: read, check, pass, write, and quality where that was measured.
  void add(const Frame& frame, double time, const PassReport& report,
           const std::vector<std::pair<std::string, double>>& seconds, const QualityChange* quality = nullptr);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

struct FilterOptions {
  bool accepts_tangled = false;                     ///< take meshes that break M3
  std::function<void(const ToolOptions&)> prepare;  ///< after parsing, before any reading; may throw UsageError
};

/// A whole mesh-to-mesh tool: adds the common options, parses, and maps `pass` over the series: reads each document,
/// checks it (structure; validity unless accepts_tangled), makes the Mesh, runs the pass, writes the mesh, and then its
/// report. `pass` may throw UsageError, InputError or NoResult; nothing of the failing mesh is written.
int run_filter(CLI::App& app, int argc, char** argv, const std::function<PassReport(Mesh&)>& pass,
               const FilterOptions& filter = {});

}  // namespace pliant
