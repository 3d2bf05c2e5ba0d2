#include "global_smoothing.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>
#include <vector>

#include "criteria_options.h"
#include "filter.h"
#include "progress_line.h"

namespace pliant {

GlobalSmoothing::GlobalSmoothing(CLI::App& app) : app_(&app) {
#ifdef PLIANT_CERES
  app.set_version_flag("--version",
                       app.get_name() +
                           " (Pliant) " PLIANT_VERSION
                           "\nPliant is under the MIT licence; this program contains Ceres Solver with parts of "
                           "SuiteSparse,\nand is as a whole distributed under the GNU General Public License, "
                           "version 2 or later.");
#endif
  CLI::Option* global =
      app.add_flag("--global", is_wanted_, "move all inner control points at once, towards the least deformation");
  app.add_option("--good", good_,
                 "with --global: elements with a scaled Jacobian of at least S, away from others, stay")
      ->type_name("S")
      ->needs(global)
      ->capture_default_str();
  app.add_option("--rings", options_.rings, "with --global: so many rings of elements around others move with them")
      ->type_name("N")
      ->needs(global)
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
}

void GlobalSmoothing::prepare() {
  if (!is_wanted_) return;
  for (const char* local : {"--max-distortion", "--max-peak", "--min-shape-ratio", "--max-turning",
                            "--min-scaled-jacobian", "--measure", "--flips", "--max-sweeps", "--split"})
    if (app_->get_option(local)->count() > 0)
      throw UsageError(std::string(local) + " does not go with --global: it is for smoothing edge by edge");
#ifndef PLIANT_CERES
  throw UsageError("--global: this smoothcurves was built without the global smoother (PLIANT_CERES=OFF)");
#endif
  options_.good = parse_positive("--good", good_);
  if (options_.good > 1) throw UsageError("--good must be at most 1");
}

SmoothOutcome GlobalSmoothing::run(Mesh& mesh, bool vertices, const RefitOptions& refit) {
#ifdef PLIANT_CERES
  options_.vertices = vertices;
  options_.refit = refit;
  if (ProgressLine* line = ProgressLine::shown()) {
    options_.progress = line->counters();
    if (options_.progress) options_.progress->start("smooth", "steps");
  }
  GlobalSmoothOutcome outcome = smooth_globally(mesh, options_);
  std::sort(outcome.invalid.begin(), outcome.invalid.end());
  std::vector<UnmendedElement> unmended;
  for (const TriangleId t : outcome.invalid) unmended.push_back(explain_unmended(mesh, t));
  return {std::move(outcome.invalid), std::move(unmended), std::move(outcome.report)};
#else
  static_cast<void>(mesh), static_cast<void>(vertices), static_cast<void>(refit);
  return {};
#endif
}

}  // namespace pliant
