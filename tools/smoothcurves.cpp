// tools/smoothcurves.cpp: makes elements less curved, and untangles those that are not valid.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <numbers>
#include <string>

#include "criteria_options.h"
#include "filter.h"
#include "global_smoothing.h"
#include "pliant/boundary/check_boundary.h"
#include "pliant/generate/remesh_patch.h"
#include "pliant/geometry/describe.h"
#include "pliant/improve/smooth_curves.h"
#include "progress_line.h"
#include "refit_option.h"

namespace {

using namespace pliant;

/// The first of the elements that stay invalid, a line each: which, where, and why.
std::string list_invalid(const SmoothOutcome& outcome, const SmoothMeans& means, double resolution) {
  constexpr std::size_t most = 20;
  std::string text;
  std::size_t count = 0;
  for (const UnmendedElement& left : outcome.unmended) {
    if (!std::binary_search(outcome.invalid.begin(), outcome.invalid.end(), left.element)) continue;
    if (++count > most) continue;
    text += "\n  element " + std::to_string(left.element) + " at " + describe_point(left.place, resolution) + ": " +
            describe(left.reason, means);
  }
  return count > most ? text + "\n  and " + std::to_string(count - most) + " more" : text;
}

struct SmoothingOptions {
  SmoothOptions smooth;
  bool keep_going = false;

  void add_bounds(CLI::App& app) {
    app.add_option("--max-distortion", distortion_, "an element is too curved above this distortion D")
        ->type_name("D")
        ->capture_default_str();
    app.add_option("--max-peak", peak_, "or where det J exceeds this many times its mean")
        ->type_name("R")
        ->capture_default_str();
    app.add_option("--min-shape-ratio", shape_,
                   "or where its curved shape is below this share of its straight triangle's")
        ->type_name("C")
        ->capture_default_str();
    app.add_option("--max-turning", turning_, "or where an edge turns by more than this angle")
        ->type_name("DEG")
        ->capture_default_str();
    app.add_option("--min-scaled-jacobian", jacobian_, "or where its scaled Jacobian is below this")
        ->type_name("SJ")
        ->capture_default_str();
  }

  void add_moves(CLI::App& app) {
    app.add_option("--measure", measure_,
                   "what optimal places are measured on: the elements, or their control triangles")
        ->check(CLI::IsMember({"element", "control"}))
        ->capture_default_str();
    app.add_flag("--vertices", smooth.vertices,
                 "also move vertices that are on no curve, where edges alone do not help (with --global: all of them)");
    app.add_flag("--flips", smooth.flips, "also flip edges of elements that are not valid");
    app.add_option("--max-sweeps", smooth.max_sweeps, "visit an element at most N times")
        ->type_name("N")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    app.add_flag("--split", smooth.split, "split constrained edges of elements that smoothing cannot mend");
  }

  void check(const ToolOptions& tool) {
    const bool is_reported = tool.verbose || !tool.report.empty();
    smooth.keep_input = is_reported   ? KeepInput::where_curved
                        : !keep_going ? KeepInput::where_invalid
                                      : KeepInput::never;
    CurvatureBounds& bounds = smooth.bounds;
    bounds.max_distortion = parse_positive("--max-distortion", distortion_);
    bounds.max_peak = parse_positive("--max-peak", peak_);
    bounds.min_shape_ratio = parse_positive("--min-shape-ratio", shape_);
    bounds.max_turning = parse_positive("--max-turning", turning_) * std::numbers::pi / 180;
    bounds.min_scaled_jacobian = parse_positive("--min-scaled-jacobian", jacobian_);
    smooth.measure = measure_ == "control" ? PlacementMeasure::control_mesh : PlacementMeasure::element;
    if (bounds.min_scaled_jacobian >= 1) throw UsageError("--min-scaled-jacobian must be below 1");
    if (bounds.max_distortion <= 1) throw UsageError("--max-distortion must be above 1");
    if (bounds.max_peak <= 1) throw UsageError("--max-peak must be above 1");
  }

 private:
  std::string distortion_ = "1.1", peak_ = "2", shape_ = "0.5", turning_ = "90", jacobian_ = "0.3";
  std::string measure_ = "element";
};

/// Why no mesh of the faces can be valid: curves that cross or touch, or have a face on the wrong side; empty where
/// there is no such fault.
std::string list_curve_faults(const BoundaryComplex& boundary) {
  std::vector<Fault> faults = check_boundary(boundary);
  if (faults.empty()) faults = check_boundary_geometry(boundary);
  if (faults.empty()) faults = check_boundary_sides(boundary);
  return faults.empty() ? "" : "\n  the curves forbid a valid mesh: " + faults.front().text;
}

double* find_value(PassReport& report, const std::string& name) {
  for (auto& [known, value] : report.values)
    if (known == name) return &value;
  return nullptr;
}

/// The report of a second smoothing with what the first one counted: its work is added, what was found at the beginning
/// is the first one's.
void add_first_smoothing(const PassReport& first, PassReport& second) {
  for (const auto& [name, value] : first.values) {
    double* const now = find_value(second, name);
    if (now == nullptr) continue;
    if (name == "too_curved" || name == "not_good" || name == "energy_before") *now = value;
    for (const char* const work : {"edges_smoothed", "vertices_moved", "searches", "flips", "turned_back", "splits",
                                   "elements_smoothed", "points_moved", "iterations"})
      if (name == work) *now += value;
  }
}

/// Meshes the regions of elements that smoothing has left invalid anew, and smooths again.
template <class Smooth>
RemeshPatchCounts remesh_what_is_left(Mesh& mesh, SmoothOutcome& outcome, const Smooth& smooth,
                                      const RefitOptions& refit) {
  const std::size_t invalid = outcome.invalid.size();
  const RemeshPatchCounts counts = remesh_invalid(mesh, refit);
  if (counts.patches == 0) return counts;
  SmoothOutcome again = smooth(mesh);
  add_first_smoothing(outcome.report, again.report);
  const std::string note = "smoothing left " + std::to_string(invalid) +
                           " elements invalid: " + std::to_string(counts.triangles_before) + " elements in " +
                           std::to_string(counts.patches) + (counts.patches == 1 ? " region" : " regions") +
                           " were replaced by " + std::to_string(counts.triangles_after) + " new ones";
  again.report.notes.insert(again.report.notes.begin(), note);
  outcome = std::move(again);
  return counts;
}

PassReport smooth(Mesh& mesh, SmoothingOptions& options, GlobalSmoothing& global) {
  const SmoothMeans means{options.smooth.vertices, options.smooth.flips, options.smooth.split};
  const auto smooth_once = [&](Mesh& each) {
    if (global.is_wanted()) return global.run(each, means.vertices, options.smooth.refit);
    if (ProgressLine* line = ProgressLine::shown()) options.smooth.progress = line->counters();
    return smooth_curves(each, options.smooth);
  };
  SmoothOutcome outcome = smooth_once(mesh);
  RemeshPatchCounts remeshed;
  if (!outcome.invalid.empty() && !options.keep_going)
    remeshed = remesh_what_is_left(mesh, outcome, smooth_once, options.smooth.refit);
  outcome.report.add("patches_remeshed", static_cast<double>(remeshed.patches));
  const std::string advice = global.is_wanted() ? "" : global.advice(outcome, mesh, means.vertices);
  if (!advice.empty()) outcome.report.notes.push_back(advice);
  if (!outcome.invalid.empty() && !options.keep_going)
    throw NoResult(std::to_string(outcome.invalid.size()) +
                   " elements stay invalid; --keep-going writes the mesh all the same" +
                   list_invalid(outcome, means, place_resolution * mesh.size()) + list_curve_faults(mesh.boundary()) +
                   (advice.empty() ? "" : "\n  " + advice));
  return outcome.report;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Smooth the edges of elements that are too curved, and untangle those that are not valid.",
               "smoothcurves"};
  SmoothingOptions options;
  options.add_bounds(app);
  options.add_moves(app);
  GlobalSmoothing global(app);
  app.add_flag("--keep-going", options.keep_going,
               "write the mesh also if elements stay invalid, and mesh no region anew");
  add_projection_option(app, options.smooth.refit);
  FilterOptions filter;
  filter.accepts_tangled = true;
  filter.prepare = [&](const ToolOptions& tool) {
    global.prepare();
    options.check(tool);
  };
  return run_filter(
      app, argc, argv, [&](Mesh& mesh) { return smooth(mesh, options, global); }, filter);
}
