#include <CLI/CLI.hpp>
#include <algorithm>
#include <numbers>
#include <string>

#include "criteria_options.h"
#include "filter.h"
#include "global_smoothing.h"
#include "pliant/geometry/describe.h"
#include "pliant/improve/smooth_curves.h"  // tools/smoothcurves.cpp
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

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Smooth the edges of elements that are too curved, and untangle those that are not valid.",
               "smoothcurves"};
  SmoothOptions options;
  std::string distortion = "1.1", peak = "2", shape = "0.5", turning = "90", jacobian = "0.3", measure = "element";
  bool keep_going = false;
  app.add_option("--max-distortion", distortion, "an element is too curved above this distortion D")
      ->type_name("D")
      ->capture_default_str();
  app.add_option("--max-peak", peak, "or where det J exceeds this many times its mean")
      ->type_name("R")
      ->capture_default_str();
  app.add_option("--min-shape-ratio", shape, "or where its curved shape is below this share of its straight triangle's")
      ->type_name("C")
      ->capture_default_str();
  app.add_option("--max-turning", turning, "or where an edge turns by more than this angle")
      ->type_name("DEG")
      ->capture_default_str();
  app.add_option("--min-scaled-jacobian", jacobian, "or where its scaled Jacobian is below this")
      ->type_name("SJ")
      ->capture_default_str();
  app.add_option("--measure", measure, "what optimal places are measured on: the elements, or their control triangles")
      ->check(CLI::IsMember({"element", "control"}))
      ->capture_default_str();
  app.add_flag("--vertices", options.vertices,
               "also move vertices that are on no curve, where edges alone do not help (with --global: all of them)");
  app.add_flag("--flips", options.flips, "also flip edges of elements that are not valid");
  app.add_option("--max-sweeps", options.max_sweeps, "visit an element at most N times")
      ->type_name("N")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_flag("--split", options.split, "split constrained edges of elements that smoothing cannot mend");
  GlobalSmoothing global(app);
  app.add_flag("--keep-going", keep_going, "write the mesh also if elements stay invalid");
  add_projection_option(app, options.refit);
  FilterOptions filter;
  filter.accepts_tangled = true;
  filter.prepare = [&](const ToolOptions& tool) {
    global.prepare();
    const bool is_reported = tool.verbose || !tool.report.empty();
    options.keep_input = is_reported   ? KeepInput::where_curved
                         : !keep_going ? KeepInput::where_invalid
                                       : KeepInput::never;
    options.bounds.max_distortion = parse_positive("--max-distortion", distortion);
    options.bounds.max_peak = parse_positive("--max-peak", peak);
    options.bounds.min_shape_ratio = parse_positive("--min-shape-ratio", shape);
    options.bounds.max_turning = parse_positive("--max-turning", turning) * std::numbers::pi / 180;
    options.bounds.min_scaled_jacobian = parse_positive("--min-scaled-jacobian", jacobian);
    options.measure = measure == "control" ? PlacementMeasure::control_mesh : PlacementMeasure::element;
    if (options.bounds.min_scaled_jacobian >= 1) throw UsageError("--min-scaled-jacobian must be below 1");
    if (options.bounds.max_distortion <= 1) throw UsageError("--max-distortion must be above 1");
    if (options.bounds.max_peak <= 1) throw UsageError("--max-peak must be above 1");
  };
  const auto smooth = [&](Mesh& mesh) -> SmoothOutcome {
    if (global.is_wanted()) return global.run(mesh, options.vertices, options.refit);
    if (ProgressLine* line = ProgressLine::shown()) options.progress = line->counters();
    return smooth_curves(mesh, options);
  };
  return run_filter(
      app, argc, argv,
      [&](Mesh& mesh) {
        SmoothOutcome outcome = smooth(mesh);
        const std::string advice = global.is_wanted() ? "" : global.advice(outcome, mesh, options.vertices);
        if (!advice.empty()) outcome.report.notes.push_back(advice);
        if (!outcome.invalid.empty() && !keep_going)
          throw NoResult(
              std::to_string(outcome.invalid.size()) +
              " elements stay invalid; --keep-going writes the mesh all the same" +
              list_invalid(outcome, {options.vertices, options.flips, options.split}, place_resolution * mesh.size()) +
              (advice.empty() ? "" : "\n  " + advice));
        return outcome.report;
      },
      filter);
}
