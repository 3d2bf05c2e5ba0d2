#include "filter.h"  // tools/filter.cpp: from the command line to an exit status, and the mapping over a series

#include <fcntl.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <new>
#include <optional>
#include <system_error>

#include "doubts.h"
#include "formats/mesh_json.h"
#include "formats/msh.h"
#include "formats/read_json.h"
#include "formats/recognize.h"
#include "pliant/geometry/describe.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/document_unit.h"
#include "progress_line.h"

namespace pliant {
namespace {

/// Bad input, or no result, with the place of its document already in the text.
class Placed : public std::runtime_error {
 public:
  Placed(int status, const std::string& text) : std::runtime_error(text), status_(status) {}
  int status() const { return status_; }

 private:
  int status_;
};

constexpr std::string_view out_of_memory =
    "this needs more memory than there is; ask for fewer or larger elements (refine and bspline2mesh: --max-triangles)";

/// Runs `work` on one document and adds the document's place to what it throws.
void with_place(const Frame& frame, std::string_view document, const std::function<void()>& work) {
  try {
    work();
  } catch (const DocumentError& e) {
    throw Placed(status::bad_input, where(frame, frame.line + e.line() - 1) + at_pointer(e.pointer(), e.what()));
  } catch (const BadMesh& e) {
    std::string text;
    for (const Fault& fault : e.faults())
      text += (text.empty() ? "" : "\n") + describe_fault(frame, document, fault.place, fault.text);
    throw Placed(status::bad_input, text);
  } catch (const InputError& e) {
    throw Placed(status::bad_input, describe_fault(frame, document, e.pointer(), e.what()));
  } catch (const NoResult& e) {
    throw Placed(status::no_result, frame.source + ": frame " + std::to_string(frame.index) + ": " + e.what());
  } catch (const std::domain_error& e) {
    throw Placed(status::no_result, frame.source + ": frame " + std::to_string(frame.index) + ": " + e.what());
  } catch (const std::bad_alloc&) {
    throw Placed(status::no_result,
                 frame.source + ": frame " + std::to_string(frame.index) + ": " + std::string(out_of_memory));
  }
}

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

void for_each_document(const ToolOptions& options, FileKind kind,
                       const std::function<void(std::string_view text, const Frame&)>& use,
                       const std::function<void(std::string_view bytes, const Frame&)>& use_msh_file = {}) {
  std::unique_ptr<std::FILE, Closer> file;
  Frame frame;
  frame.source = "standard input";
  if (options.input != "-") {
    frame.source = options.input;
    file.reset(std::fopen(options.input.c_str(), "rb"));
    if (file == nullptr) throw std::system_error(errno, std::generic_category(), options.input);
  }
  DocumentStream stream(file == nullptr ? stdin : file.get(), frame.source);
  if (use_msh_file) {
    const std::string_view bytes = stream.all_if("$");
    if (!bytes.empty()) return use_msh_file(bytes, frame);
  }
  const std::string head(stream.head_unless_object(recognized_by));
  std::string_view document;
  while (stream.next(document)) {
    frame.index = stream.frame();
    frame.line = stream.first_line();
    try {
      with_place(frame, document, [&] { use(document, frame); });
    } catch (const Placed& e) {
      const std::string other = e.status() == status::bad_input && frame.index == 0
                                    ? describe_other_kind(head.empty() ? document : head, kind)
                                    : "";
      if (other.empty()) throw;
      throw Placed(status::bad_input, frame.source + ": " + other);
    }
  }
  if (stream.frame() < 0)
    throw Placed(status::bad_input,
                 frame.source + ":1: the input is empty" + (options.input == "-" ? "" : "; expected a document"));
}

/// Says which triangles are which elements, in a few lines or not at all.
void say_numbers(const ToolOptions& options, const Frame& frame, const TagRuns& elements) {
  const std::vector<TagRuns::Run>& runs = elements.runs();
  constexpr std::size_t most = 20;
  for (std::size_t k = 0; k < runs.size() && runs.size() <= most; ++k) {
    const std::size_t end = k + 1 < runs.size() ? runs[k + 1].first : elements.size();
    say(options, frame.source + ": triangles " + std::to_string(runs[k].first) + " to " + std::to_string(end - 1) +
                     " are elements " + std::to_string(runs[k].tag) + " to " +
                     std::to_string(runs[k].tag + (end - 1 - runs[k].first)));
  }
}

void use_msh(const ToolOptions& options, const MshOptions& msh, std::string_view bytes, const Frame& frame,
             const std::function<void(MshImport&&, const Frame&)>& use) {
  try {
    MshImport import = read_msh(bytes, msh);
    for (const std::string& text : import.warnings) say(options, frame.source + ": " + text);
    if (options.verbose) say_numbers(options, frame, import.elements);
    use(std::move(import), frame);
  } catch (const InputError& e) {
    throw Placed(status::bad_input, frame.source + ": " + at_pointer(e.pointer(), e.what()));
  } catch (const NoResult& e) {
    throw Placed(status::no_result, frame.source + ": " + e.what());
  }
}

std::string list_elements(const InvalidElements& bad) {
  constexpr std::size_t most = 8;
  std::string text;
  std::size_t count = 0;
  for (const auto* elements : {&bad.invalid, &bad.degenerate})
    for (const TriangleId t : *elements)
      if (count++ < most) text += (text.empty() ? "" : ", ") + std::to_string(t);
  return count > most ? text + ", ..." : text;
}

/// A closed standard stream must not hand its descriptor to a file that is opened later.
void keep_standard_descriptors() {
  for (const int fd : {0, 1, 2})
    if (fcntl(fd, F_GETFD) < 0 && errno == EBADF) (void)!open("/dev/null", fd == 0 ? O_WRONLY : O_RDONLY);
}

}  // namespace

BadMesh::BadMesh(std::vector<Fault> faults)
    : InputError(faults.front().place, faults.front().text), faults_(std::move(faults)) {}

void add_common_options(CLI::App& app, ToolOptions& options, bool with_report) {
  options.tool = app.get_name();
  app.add_option("INPUT", options.input, "a file, or - for standard input")->capture_default_str();
  app.add_option("-o,--output", options.output, "write to this file, whole or not at all")->type_name("FILE");
  if (with_report)
    app.add_option("--report", options.report, "write what was done to this file, a line of JSON a frame")
        ->type_name("FILE");
  auto* quiet =
      app.add_flag("-q,--quiet", options.quiet, "no progress, no summary, no warnings; errors are said all the same");
  app.add_flag("-v,--verbose", options.verbose, "say what was done")->excludes(quiet);
  if (app.get_version_ptr() == nullptr)  // else the tool has more to say
    app.set_version_flag("--version", app.get_name() + " (Pliant) " PLIANT_VERSION);
}

int run_tool(CLI::App& app, int argc, char** argv, ToolOptions& options, const std::function<int()>& body) {
  std::signal(SIGPIPE, SIG_DFL);  // also where the parent ignores it
  keep_standard_descriptors();
  const auto stop = [&](int exit_status, const std::string& text) {
    // Each line of the text is a message of its own.
    std::string out;
    for (std::size_t first = 0, last = 0; first <= text.size() && last != std::string::npos; first = last + 1) {
      last = text.find('\n', first);
      out += options.tool + ": " + text.substr(first, last == std::string::npos ? last : last - first) + "\n";
    }
    std::fputs(out.c_str(), stderr);
    return exit_status;
  };
  options.tool = app.get_name();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() != 0)
      return stop(status::wrong_usage,
                  explain_usage(app, e.what()) + "\n`" + options.tool + " --help` lists the options");
    app.exit(e);
    return std::fflush(stdout) == 0 && std::cout.flush() ? status::done : stop(status::io_failed, "cannot write");
  }
  try {
    return body();
  } catch (const Placed& e) {
    return stop(e.status(), e.what());
  } catch (const UsageError& e) {
    return stop(status::wrong_usage, e.what());
  } catch (const InputError& e) {
    return stop(status::bad_input, at_pointer(e.pointer(), e.what()));
  } catch (const NoResult& e) {
    return stop(status::no_result, e.what());
  } catch (const std::system_error& e) {
    return stop(status::io_failed, e.what());
  } catch (const std::bad_alloc&) {
    return stop(status::no_result, std::string(out_of_memory));
  } catch (const std::exception& e) {
    return stop(status::no_result, e.what());
  }
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

void for_each_mesh(const ToolOptions& options, const std::function<void(MeshData&&, const Frame&)>& use) {
  Doubts doubts(options);
  const auto use_document = [&](std::string_view text, const Frame& frame) {
    MeshData data = read_mesh(text, doubts.found());
    doubts.say_new(text, frame);
    require_document_size(data);
    use(std::move(data), frame);
  };
  if (!options.takes_msh) return for_each_document(options, FileKind::mesh, use_document);
  for_each_document(options, FileKind::mesh, use_document, [&](std::string_view bytes, const Frame& frame) {
    use_msh(options, {}, bytes, frame, [&](MshImport&& import, const Frame&) {
      require_document_size(import.mesh);
      if (options.verbose)
        for (const std::string& text : import.notes) say(options, frame.source + ": " + text);
      use(std::move(import.mesh), frame);
    });
  });
}

void for_msh(const ToolOptions& options, const MshOptions& msh,
             const std::function<void(MshImport&&, const Frame&)>& use) {
  // What is no MSH file goes to its reader all the same, which says so.
  const auto refuse = [&](std::string_view text, const Frame& frame) { use_msh(options, msh, text, frame, use); };
  for_each_document(options, FileKind::msh, refuse, refuse);
}

void for_each_boundary(const ToolOptions& options, const std::function<void(BoundaryComplex&&, const Frame&)>& use) {
  Doubts doubts(options);
  for_each_document(options, FileKind::boundary, [&](std::string_view text, const Frame& frame) {
    BoundaryComplex boundary = read_boundary(text, doubts.found());
    doubts.say_new(text, frame);
    use(std::move(boundary), frame);
  });
}

std::string explain_unit(double unit) {
  if (unit == 1) return {};
  return "places and lengths are given in units of 2^" + std::to_string(std::ilogb(unit));
}

void in_unit(double unit, const std::function<void()>& work) {
  if (unit == 1) return work();
  const std::string tail = " (" + explain_unit(unit) + ")";
  try {
    work();
  } catch (const BadMesh& e) {
    std::vector<Fault> faults = e.faults();
    for (Fault& fault : faults) fault.text += tail;
    throw BadMesh(std::move(faults));
  } catch (const InputError& e) {
    throw InputError(e.pointer(), e.what() + tail);
  } catch (const NoResult& e) {
    throw NoResult(e.what() + tail);
  }
}

void require_mesh(const MeshData& data, bool accepts_tangled) {
  std::vector<Fault> faults = check_structure(data, 3);
  constexpr std::size_t most = 10;
  if (faults.size() > most) faults.resize(most);
  for (Fault& fault : faults) fault.text += " (" + fault.invariant + ")";
  if (!faults.empty()) throw BadMesh(std::move(faults));
  if (accepts_tangled) return;
  const InvalidElements bad = find_invalid(data);
  if (bad.empty()) return;
  const std::size_t count = bad.invalid.size() + bad.degenerate.size();
  const TriangleId first = bad.invalid.empty() ? bad.degenerate.front() : bad.invalid.front();
  const std::size_t all = data.triangle_faces.size();
  throw BadMesh({{"M3", "/triangles/" + std::to_string(first * net_size(data.degree)),
                  std::to_string(count) + " of " + std::to_string(all) + " elements are not valid (" +
                      list_elements(bad) + "); smoothcurves may untangle them"}});
}

void report_in_document(PassReport& report, double unit) {
  restore_unit(report, unit);
  if (unit != 1 && !report.notes.empty()) report.notes.push_back("in these notes " + explain_unit(unit));
}

int run_filter(CLI::App& app, int argc, char** argv, const std::function<PassReport(Mesh&)>& pass,
               const FilterOptions& filter) {
  ToolOptions options;
  add_common_options(app, options);
  return run_tool(app, argc, argv, options, [&] {
    if (filter.prepare) filter.prepare(options);
    OutputFile output(options.output);
    FrameReports reports(options);
    ProgressLine line(options);
    Stopwatch watch;
    std::string text;
    Doubts doubts(options);
    for_each_document(options, FileKind::mesh, [&](std::string_view document, const Frame& frame) {
      watch.lap();
      line.stage("read");
      MeshData data = read_mesh(document, doubts.found());
      doubts.say_new(document, frame);
      normalize_unit(data);
      const double unit = data.boundary.unit;
      std::vector<std::pair<std::string, double>> seconds{{"read", watch.lap()}};
      line.stage("check");
      in_unit(unit, [&] { require_mesh(data, filter.accepts_tangled); });
      double checking = watch.lap(), measuring = 0;
      std::optional<QualityChange> quality;
      if (reports.is_wanted()) {
        quality.emplace().before = summarize_quality(data);
        measuring = watch.lap();
      }
      Mesh mesh(std::move(data));
      seconds.emplace_back("check", checking + watch.lap());
      line.stage("work");
      PassReport report;
      in_unit(unit, [&] { report = pass(mesh); });
      report.resolution = place_resolution * mesh.size();
      report_in_document(report, unit);
      seconds.emplace_back("pass", watch.lap());
      line.stage("write");
      text.clear();
      data = mesh.to_data();
      const double unpacking = watch.lap();
      if (quality) {  // before the mesh may have its extreme size again
        line.stage("measure");
        quality->after = summarize_quality(data);
        for (QualitySummary* summary : {&quality->before, &quality->after})
          for (ComponentSize& size : summary->fields) size.l2 *= unit;  // the root of an integral over the area
        measuring += watch.lap();
        line.stage("write");
      }
      restore_unit(data);
      write_mesh(data, text);
      output.write(text);
      seconds.emplace_back("write", unpacking + watch.lap());
      if (quality) seconds.emplace_back("quality", measuring);
      reports.add(frame, mesh.time, report, seconds, quality ? &*quality : nullptr);
    });
    output.commit();
    return status::done;
  });
}

}  // namespace pliant
