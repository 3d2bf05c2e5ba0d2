// tools/global_smoothing.cpp: smoothcurves --global and its options, also in builds without the smoother.
#include "global_smoothing.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "criteria_options.h"
#include "filter.h"
#include "pliant/quality/least_quality.h"
#include "progress_line.h"

namespace pliant {
#ifdef PLIANT_CERES
namespace {

/// How many elements may take part in a trial: some tenth of a second at degrees 2 to 5 (tests/bench).
std::size_t most_on_trial(const Mesh& mesh) {
  return 100000 / static_cast<std::size_t>(mesh.net_size() * mesh.net_size());
}
constexpr std::size_t elements_around = 40;  // of one element, in the rings that move with it
constexpr double clearly = 0.01;             // a least value is higher by this share

struct Standing {
  std::size_t invalid;
  LeastQuality least;
};
bool is_better(const Standing& a, const Standing& b) {
  if (a.invalid != b.invalid) return a.invalid < b.invalid;
  if (!a.least.is_at_least(b.least)) return false;
  const auto is_higher = [](double x, double y) { return x > y + clearly * std::fabs(y); };
  return is_higher(a.least.shape, b.least.shape) || is_higher(a.least.scaled_jacobian, b.least.scaled_jacobian);
}
std::string describe(const Standing& standing) {
  char text[96];
  std::snprintf(text, sizeof text, "%zu elements not valid, least scaled Jacobian %.4g, least shape %.4g",
                standing.invalid, standing.least.scaled_jacobian, standing.least.shape);
  return text;
}

}  // namespace
#endif

std::string GlobalSmoothing::advice(SmoothOutcome& outcome, const Mesh& result, bool vertices) const {
#ifdef PLIANT_CERES
  if (!outcome.input || outcome.unmended.empty()) return {};
  Mesh& trial = *outcome.input;
  GlobalSmoothOptions options;
  options.vertices = vertices;
  const std::size_t most = most_on_trial(trial);
  const bool is_whole = static_cast<std::size_t>(trial.triangle_count()) <= most;
  if (!is_whole) {
    std::vector<TriangleId>& poor = outcome.input_poor;
    poor.resize(std::min(poor.size(), std::max<std::size_t>(1, most / elements_around)));
    options.only = poor;
  }
  const Standing local{outcome.invalid.size(), least_quality_of_mesh(result)};
  const GlobalSmoothOutcome tried = smooth_globally(trial, options);
  Standing global{tried.invalid.size(), {}};
  if (is_whole) {
    global.least = least_quality_of_mesh(trial);
  } else {  // what is not on trial, neither smoother finds hard
    global.least = least_quality(trial, tried.elements);
    global.invalid =
        static_cast<std::size_t>(std::count_if(tried.elements.begin(), tried.elements.end(), [&](TriangleId t) {
          return std::binary_search(tried.invalid.begin(), tried.invalid.end(), t);
        }));
  }
  if (!is_better(global, local)) return {};
  return std::string("--global") + (vertices ? " with --vertices" : "") + " in place of the local smoother " +
         (is_whole ? "does" : "probably does") + " better: " + describe(global) + ", against " + describe(local);
#else
  static_cast<void>(outcome), static_cast<void>(result), static_cast<void>(vertices);
  return {};
#endif
}

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
  std::vector<UnmendedElement> unmended;
  for (const TriangleId t : outcome.invalid) unmended.push_back(explain_unmended(mesh, t));
  SmoothOutcome result;
  result.invalid = std::move(outcome.invalid);
  result.unmended = std::move(unmended);
  result.report = std::move(outcome.report);
  return result;
#else
  static_cast<void>(mesh), static_cast<void>(vertices), static_cast<void>(refit);
  return {};
#endif
}

}  // namespace pliant
