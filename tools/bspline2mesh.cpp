// tools/bspline2mesh.cpp: from boundary documents to meshes: check, generate, refine.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

#include "formats/document/history.h"
#include "formats/document/mesh_document.h"
#include "options/criteria_options.h"
#include "options/field_option.h"
#include "options/numbers.h"
#include "options/triangle_limit.h"
#include "pliant/boundary/arrangement.h"
#include "pliant/boundary/check_boundary.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/generate/refine_first_mesh.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/documents/document_unit.h"
#include "run/documents.h"
#include "run/exit_status.h"
#include "run/frame_reports.h"
#include "run/history.h"
#include "run/in_unit.h"
#include "run/output_file.h"
#include "run/progress_line.h"
#include "run/run_tool.h"
#include "run/stopwatch.h"

namespace {

using namespace pliant;

/// Replaces a boundary whose curves may cross by the disjoint faces that they come to.
void resolve_crossings(BoundaryComplex& boundary, PassReport& report) {
  if (std::vector<Fault> faults = check_boundary(boundary); !faults.empty()) throw BadMesh(std::move(faults));
  Arrangement arrangement = resolve(boundary);
  if (!arrangement.faults.empty()) {
    const std::size_t more = arrangement.faults.size() - 1;
    throw NoResult("the curves could not be resolved: " + arrangement.faults.front().text +
                   (more > 0 ? " (and " + std::to_string(more) + " more)" : ""));
  }
  if (arrangement.boundary.curves.empty()) throw NoResult("the curves enclose nothing once they are resolved");
  report.add("intersections", static_cast<double>(arrangement.intersections));
  report.add("regions", static_cast<double>(arrangement.regions));
  report.add("slivers_collapsed", static_cast<double>(arrangement.slivers));
  for (std::size_t f = 0, kept = 0; f < boundary.faces.size(); ++f)
    if (kept < arrangement.sources.size() && arrangement.sources[kept] == static_cast<int>(f))
      ++kept;
    else
      report.notes.push_back("nothing is left of face '" + boundary.faces[f].name + "'");
  arrangement.boundary.unit = boundary.unit;
  boundary = std::move(arrangement.boundary);
}

void require_boundary(const BoundaryComplex& boundary) {
  std::vector<Fault> faults = check_boundary(boundary);
  if (faults.empty()) faults = check_boundary_geometry(boundary);
  if (faults.empty()) faults = check_boundary_sides(boundary);
  if (faults.empty()) return;
  if (std::any_of(faults.begin(), faults.end(), [](const Fault& fault) { return fault.invariant == "contact"; }))
    faults.push_back({"contact", "", "--resolve cuts curves where they cross, touch or overlap"});
  throw BadMesh(std::move(faults));
}

/// What the command line asks for.
struct MeshingOptions {
  ToolOptions tool;
  GenerateOptions generate;
  CriteriaOptions criteria;
  FieldOption fields;
  double time = 0;
  long max_triangles = RefineOptions().max_triangles;
  bool no_refine = false, resolves = false;

  void add(CLI::App& app) {
    add_common_options(app, tool);
    add_form_option(app, tool);
    app.add_option("--degree", degree_text_, "degree of the mesh, 1 to 10; default: the curves' greatest, at least 2")
        ->type_name("N");
    app.add_flag("--resolve", resolves,
                 "let curves cross, touch and overlap: cut them there; later faces lie over earlier ones");
    criteria.add(app, false);
    add_max_triangles(app, max_triangles);
    app.add_flag("--no-refine", no_refine, "keep the first valid mesh, whatever the criteria");
    fields.add(app);
    app.add_option("--time", time_text_, "time of the mesh")->type_name("T")->capture_default_str();
  }

  void check() {
    if (!degree_text_.empty()) {
      const double degree = parse_number("--degree", degree_text_);
      generate.degree = static_cast<int>(degree);
      if (degree != generate.degree || degree < 1 || degree > max_degree)
        throw UsageError("--degree: '" + degree_text_ + "' is not a whole number from 1 to " +
                         std::to_string(max_degree));
    }
    time = parse_number("--time", time_text_);
    criteria.check();
    fields.check();
  }

 private:
  std::string time_text_ = "0", degree_text_;
};

/// One boundary after the other, to meshes; memory and watch go on from frame to frame.
class Meshing {
 public:
  Meshing(const MeshingOptions& options, ProgressLine& line, OutputFile& output, FrameReports& reports)
      : options_(options), line_(line), output_(output), reports_(reports) {}

  /// Meshes a boundary and writes the mesh and its report.
  void run(BoundaryComplex& boundary, const Frame& frame) {
    seconds_.assign(1, {"read", watch_.lap()});
    require_recordable(options_.tool, boundary.extra);
    PassReport report;
    Mesh mesh = generate(boundary, report);
    seconds_.emplace_back("generate", watch_.lap());
    if (options_.no_refine)
      options_.criteria.apply(mesh.criteria, mesh.boundary());
    else
      report.append(refine_to_criteria(mesh));
    seconds_.emplace_back("refine", watch_.lap());
    line_.stage("write");
    options_.fields.apply(mesh);
    if (!find_invalid(mesh).empty()) throw NoResult("elements of the result are not valid");
    report_in_document(report, boundary.unit);
    MeshData data = mesh.to_data();
    restore_unit(data);
    inherit_history(data.boundary.extra, data.extra);
    record(options_.tool, data.extra);
    write_mesh(data, options_.tool.output_form(frame.form), [this](std::string_view piece) { output_.write(piece); });
    seconds_.emplace_back("write", watch_.lap());
    reports_.add(frame, mesh.time, report, seconds_);
    line_.frames_done(frame.index + 1);
  }

 private:
  /// The first mesh of a boundary, once that is checked.
  Mesh generate(BoundaryComplex& boundary, PassReport& report) {
    line_.stage(options_.resolves ? "resolve" : "check");
    PassReport resolved;
    if (options_.resolves)
      resolve_crossings(boundary, resolved);
    else
      require_boundary(boundary);
    seconds_.emplace_back("check", watch_.lap());
    line_.stage("generate");
    Mesh mesh;
    GenerateOutcome outcome = mesh_from_boundary(boundary, options_.generate, mesh);
    if (!outcome.ok) throw NoResult(outcome.failure);
    report = std::move(resolved);
    report.append(outcome.report);
    mesh.time = options_.time;
    return mesh;
  }

  /// Refines to the criteria of the options, which are written into the mesh.
  PassReport refine_to_criteria(Mesh& mesh) {
    RefineOptions refine;
    refine.goals = options_.criteria.goals(mesh);
    refine.max_triangles = options_.max_triangles;
    refine.progress = line_.counters();
    warn_of_thin_gaps(mesh, *refine.goals, [&](const std::string& text) { say(options_.tool, text); });
    return refine_first_mesh(mesh, refine);
  }

  const MeshingOptions& options_;
  ProgressLine& line_;
  OutputFile& output_;
  FrameReports& reports_;
  Stopwatch watch_;
  std::vector<std::pair<std::string, double>> seconds_;  // what each stage took
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Mesh the faces that B-spline curves bound with valid Bezier triangles.", "bspline2mesh"};
  MeshingOptions options;
  options.add(app);
  return run_tool(app, argc, argv, options.tool, [&] {
    options.check();
    OutputFile output(options.tool.output);
    FrameReports reports(options.tool);
    ProgressLine line(options.tool);
    options.generate.progress = line.counters();
    Meshing meshing(options, line, output, reports);
    for_each_boundary(options.tool, [&](BoundaryComplex&& boundary, const Frame& frame) {
      normalize_unit(boundary);
      in_unit(boundary.unit, [&] { meshing.run(boundary, frame); });
      line.stage("read");
    });
    output.commit();
    return status::done;
  });
}
