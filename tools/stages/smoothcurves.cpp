// tools/stages/smoothcurves.cpp: the options of smoothcurves, and what it says of elements that stay invalid.
#include "stages/smoothcurves.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numbers>
#include <string>

#include "options/numbers.h"
#include "options/refit_option.h"
#include "pliant/boundary/check_boundary.h"
#include "pliant/generate/smooth_or_remesh.h"
#include "pliant/geometry/describe.h"
#include "run/exit_status.h"

namespace pliant {
namespace {

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

/// Why no mesh of the faces can be valid: curves that cross or touch, or have a face on the wrong side; empty where
/// there is no such fault.
std::string list_curve_faults(const BoundaryComplex& boundary) {
  std::vector<Fault> faults = check_boundary(boundary);
  if (faults.empty()) faults = check_boundary_geometry(boundary);
  if (faults.empty()) faults = check_boundary_sides(boundary);
  return faults.empty() ? "" : "\n  the curves forbid a valid mesh: " + faults.front().text;
}

}  // namespace

void SmoothCurvesStage::add_bounds(CLI::App& app) {
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

void SmoothCurvesStage::add_moves(CLI::App& app) {
  app.add_option("--measure", measure_, "what optimal places are measured on: the elements, or their control triangles")
      ->check(CLI::IsMember({"element", "control"}))
      ->capture_default_str();
  app.add_flag("--vertices", options_.vertices,
               "also move vertices that are on no curve, where edges alone do not help (with --global: all of them)");
  app.add_flag("--flips", options_.flips, "also flip edges of elements that are not valid");
  app.add_option("--max-sweeps", options_.max_sweeps, "visit an element at most N times")
      ->type_name("N")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_flag("--split", options_.split, "split constrained edges of elements that smoothing cannot mend");
}

void SmoothCurvesStage::add_options(CLI::App& app) {
  add_bounds(app);
  add_moves(app);
  global_.add(app);
  app.add_flag("--keep-going", keep_going_, "write the mesh also if elements stay invalid, and mesh no region anew");
  add_projection_option(app, options_.refit);
}

void SmoothCurvesStage::check(const CLI::App& app) {
  global_.check(app);
  CurvatureBounds& bounds = options_.bounds;
  bounds.max_distortion = parse_positive("--max-distortion", distortion_);
  bounds.max_peak = parse_positive("--max-peak", peak_);
  bounds.min_shape_ratio = parse_positive("--min-shape-ratio", shape_);
  bounds.max_turning = parse_positive("--max-turning", turning_) * std::numbers::pi / 180;
  bounds.min_scaled_jacobian = parse_positive("--min-scaled-jacobian", jacobian_);
  options_.measure = measure_ == "control" ? PlacementMeasure::control_mesh : PlacementMeasure::element;
  if (bounds.min_scaled_jacobian >= 1) throw UsageError("--min-scaled-jacobian must be below 1");
  if (bounds.max_distortion <= 1) throw UsageError("--max-distortion must be above 1");
  if (bounds.max_peak <= 1) throw UsageError("--max-peak must be above 1");
}

PassReport SmoothCurvesStage::run(Mesh& mesh, const StageContext& context) const {
  SmoothOptions options = options_;
  options.progress = context.progress;
  if (global_.has_smoother())  // for its advice
    options.keep_input = context.wants_details ? KeepInput::where_curved
                         : !keep_going_        ? KeepInput::where_invalid
                                               : KeepInput::never;
  const SmoothMeans means{options.vertices, options.flips, options.split};
  const auto smooth_once = [&](Mesh& each) {
    return global_.is_wanted() ? global_.run(each, means.vertices, options.refit, context)
                               : smooth_curves(each, options);
  };
  SmoothOutcome outcome = keep_going_ ? smooth_once(mesh) : smooth_or_remesh(mesh, smooth_once, options.refit);
  if (keep_going_) outcome.report.add("patches_remeshed", 0);
  const std::string advice = global_.is_wanted() ? "" : global_.advice(outcome, mesh, means.vertices);
  if (!advice.empty()) outcome.report.notes.push_back(advice);
  if (!outcome.invalid.empty() && !keep_going_)
    throw NoResult(std::to_string(outcome.invalid.size()) +
                   " elements stay invalid; --keep-going writes the mesh all the same" +
                   list_invalid(outcome, means, place_resolution * mesh.size()) + list_curve_faults(mesh.boundary()) +
                   (advice.empty() ? "" : "\n  " + advice));
  return outcome.report;
}

}  // namespace pliant
