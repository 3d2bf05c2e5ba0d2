#include <CLI/CLI.hpp>
#include <numbers>

#include "criteria_options.h"
#include "filter.h"
#include "pliant/improve/smooth_curves.h"  // tools/smoothcurves.cpp
#include "refit_option.h"

namespace {

using namespace pliant;

std::string list_elements(const std::vector<TriangleId>& elements) {
  std::string text;
  for (std::size_t k = 0; k < elements.size() && k < 10; ++k) text += (k ? ", " : "") + std::to_string(elements[k]);
  return text + (elements.size() > 10 ? ", ..." : "");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Smooth the edges of elements that are too curved, and untangle those that are not valid.",
               "smoothcurves"};
  SmoothOptions options;
  std::string distortion = "1.1", peak = "2", shape = "0.5", turning = "90";
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
  app.add_option("--max-sweeps", options.max_sweeps, "visit an element at most N times")
      ->type_name("N")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_flag("--split", options.split, "split constrained edges of elements that smoothing cannot mend");
  app.add_flag("--keep-going", keep_going, "write the mesh also if elements stay invalid");
  add_projection_option(app, options.refit);
  FilterOptions filter;
  filter.accepts_tangled = true;
  filter.prepare = [&](const ToolOptions&) {
    options.bounds.max_distortion = parse_positive("--max-distortion", distortion);
    options.bounds.max_peak = parse_positive("--max-peak", peak);
    options.bounds.min_shape_ratio = parse_positive("--min-shape-ratio", shape);
    options.bounds.max_turning = parse_positive("--max-turning", turning) * std::numbers::pi / 180;
    if (options.bounds.max_distortion <= 1) throw UsageError("--max-distortion must be above 1");
    if (options.bounds.max_peak <= 1) throw UsageError("--max-peak must be above 1");
  };
  return run_filter(
      app, argc, argv,
      [&](Mesh& mesh) {
        const SmoothOutcome outcome = smooth_curves(mesh, options);
        if (!outcome.invalid.empty() && !keep_going)
          throw NoResult(std::to_string(outcome.invalid.size()) + " elements stay invalid (" +
                         list_elements(outcome.invalid) + "); --keep-going writes the mesh all the same");
        return outcome.report;
      },
      filter);
}
