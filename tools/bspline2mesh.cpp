// tools/bspline2mesh.cpp: from boundary documents to meshes: check, generate, refine
#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

#include "criteria_options.h"
#include "expression.h"
#include "field_option.h"
#include "filter.h"
#include "formats/mesh_json.h"
#include "pliant/boundary/arrangement.h"
#include "pliant/boundary/check_boundary.h"
#include "pliant/generate/mesh_from_boundary.h"
#include "pliant/improve/refine.h"
#include "pliant/improve/share_bends.h"
#include "pliant/improve/straighten_edges.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/document_unit.h"
#include "progress_line.h"

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

/// Refines to the criteria of the options and of the document; writes them into it.
void refine_to(Mesh& mesh, const CriteriaOptions& criteria, const ToolOptions& tool, long max_triangles,
               PassReport& report) {
  RefineOptions options;
  options.max_triangles = max_triangles;
  options.goals = criteria.goals(mesh, compile_size);
  warn_of_thin_gaps(tool, mesh, options.goals);
  options.progress = start_refinement(mesh, options.goals);
  if (!mesh.criteria.min_angle) mesh.criteria.min_angle = options.goals.min_angle;
  options.refit.straight_below = 0.05;  // inner edges become straight in the end
  PassReport refined = refine(mesh, options);
  report.values.insert(report.values.end(), refined.values.begin(), refined.values.end());
  report.refusals.insert(report.refusals.end(), refined.refusals.begin(), refined.refusals.end());
  report.refused_at.insert(report.refused_at.end(), refined.refused_at.begin(), refined.refused_at.end());
  report.notes.insert(report.notes.end(), refined.notes.begin(), refined.notes.end());
  if (ProgressLine* line = ProgressLine::shown()) line->stage("straighten");
  const StraightenCounts edges = straighten_edges(mesh);
  report.add("edges_straightened", static_cast<double>(edges.straightened));
  report.add("edges_left_curved", static_cast<double>(edges.left));
  report.add("elements_levelled", static_cast<double>(share_bends(mesh).levelled));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Mesh the faces that B-spline curves bound with valid Bezier triangles.", "bspline2mesh"};
  ToolOptions options;
  GenerateOptions generate;
  CriteriaOptions criteria;
  FieldOption fields;
  std::string time_text = "0", degree_text;
  long max_triangles = RefineOptions().max_triangles;
  bool no_refine = false, resolves = false;
  add_common_options(app, options);
  app.add_option("--degree", degree_text, "degree of the mesh, 1 to 10; default: the curves' greatest, at least 2")
      ->type_name("N");
  app.add_flag("--resolve", resolves,
               "let curves cross, touch and overlap: cut them there; later faces lie over earlier ones");
  criteria.add(app, false);
  add_max_triangles(app, max_triangles);
  app.add_flag("--no-refine", no_refine, "keep the first valid mesh, whatever the criteria");
  fields.add(app);
  app.add_option("--time", time_text, "time of the mesh")->type_name("T")->capture_default_str();
  return run_tool(app, argc, argv, options, [&] {
    if (!degree_text.empty()) {
      const double degree = parse_number("--degree", degree_text);
      generate.degree = static_cast<int>(degree);
      if (degree != generate.degree || degree < 1 || degree > max_degree)
        throw UsageError("--degree: '" + degree_text + "' is not a whole number from 1 to " +
                         std::to_string(max_degree));
    }
    const double time = parse_number("--time", time_text);
    criteria.check();
    fields.check();
    OutputFile output(options.output);
    FrameReports reports(options);
    ProgressLine line(options);
    generate.progress = line.counters();
    Stopwatch watch;
    std::string text;
    for_each_boundary(options, [&](BoundaryComplex&& boundary, const Frame& frame) {
      normalize_unit(boundary);
      const double unit = boundary.unit;
      in_unit(unit, [&] {
        const double read = watch.lap();
        line.stage(resolves ? "resolve" : "check");
        PassReport resolved;
        if (resolves)
          resolve_crossings(boundary, resolved);
        else
          require_boundary(boundary);
        const double check = watch.lap();
        line.stage("generate");
        Mesh mesh;
        GenerateOutcome outcome = mesh_from_boundary(boundary, generate, mesh);
        if (!outcome.ok) throw NoResult(outcome.failure);
        for (std::size_t& k : outcome.report.lengths) k += resolved.values.size();
        outcome.report.values.insert(outcome.report.values.begin(), resolved.values.begin(), resolved.values.end());
        outcome.report.notes.insert(outcome.report.notes.begin(), resolved.notes.begin(), resolved.notes.end());
        mesh.time = time;
        const double first = watch.lap();
        if (no_refine)
          criteria.apply(mesh.criteria, mesh.boundary());
        else
          refine_to(mesh, criteria, options, max_triangles, outcome.report);
        const double refined = watch.lap();
        line.stage("write");
        fields.apply(mesh);
        if (!find_invalid(mesh).empty()) throw NoResult("elements of the result are not valid");
        text.clear();
        report_in_document(outcome.report, unit);
        MeshData data = mesh.to_data();
        restore_unit(data);
        write_mesh(data, text);
        output.write(text);
        reports.add(
            frame, mesh.time, outcome.report,
            {{"read", read}, {"check", check}, {"generate", first}, {"refine", refined}, {"write", watch.lap()}});
      });
      line.stage("read");
    });
    output.commit();
    return status::done;
  });
}
