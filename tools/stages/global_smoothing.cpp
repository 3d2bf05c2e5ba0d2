// tools/stages/global_smoothing.cpp: smoothcurves --global and its options, also in programs without the smoother.
#include "stages/global_smoothing.h"

#include <CLI/CLI.hpp>

#include "options/numbers.h"
#include "run/exit_status.h"
#include "stages/stage.h"

namespace pliant {

void GlobalSmoothing::add(CLI::App& app) {
  if (smoother_ != nullptr)
    app.set_version_flag("--version", app.get_name() + " (Pliant) " PLIANT_VERSION "\n" + smoother_->licence);
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

void GlobalSmoothing::check(const CLI::App& app) {
  if (!is_wanted_) return;
  for (const char* local : {"--max-distortion", "--max-peak", "--min-shape-ratio", "--max-turning",
                            "--min-scaled-jacobian", "--measure", "--flips", "--max-sweeps", "--split"})
    if (app.get_option(local)->count() > 0)
      throw UsageError(std::string(local) + " does not go with --global: it is for smoothing edge by edge");
  if (smoother_ == nullptr)
    throw UsageError(
        "--global: this program was built without the global smoother: smoothcurves has it, unless it was built with "
        "PLIANT_CERES=OFF; the other programs that run smoothcurves as a step do not");
  options_.good = parse_positive("--good", good_);
  if (options_.good > 1) throw UsageError("--good must be at most 1");
}

SmoothOutcome GlobalSmoothing::run(Mesh& mesh, bool vertices, const RefitOptions& refit,
                                   const StageContext& context) const {
  GlobalSmoothOptions options = options_;
  options.vertices = vertices;
  options.refit = refit;
  options.progress = context.progress;
  return smoother_->smooth(mesh, options);
}

std::string GlobalSmoothing::advice(SmoothOutcome& outcome, const Mesh& result, bool vertices) const {
  return smoother_ == nullptr ? "" : smoother_->advice(outcome, result, vertices);
}

}  // namespace pliant
