// tools/stages/ceres_smoother.cpp: the global smoother, and a trial of it where local smoothing has left something.
#include "stages/ceres_smoother.h"

#ifdef PLIANT_CERES
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "pliant/quality/least_quality.h"
#endif

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

SmoothOutcome smooth(Mesh& mesh, const GlobalSmoothOptions& options) {
  if (options.progress != nullptr) options.progress->start("smooth", "steps");
  GlobalSmoothOutcome outcome = smooth_globally(mesh, options);
  std::vector<UnmendedElement> unmended;
  for (const TriangleId t : outcome.invalid) unmended.push_back(explain_unmended(mesh, t));
  SmoothOutcome result;
  result.invalid = std::move(outcome.invalid);
  result.unmended = std::move(unmended);
  result.report = std::move(outcome.report);
  return result;
}

std::string advise(SmoothOutcome& outcome, const Mesh& result, bool vertices) {
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
}

constexpr GlobalSmoother with_ceres{
    smooth, advise,
    "Pliant is under the MIT licence; this program contains Ceres Solver with parts of SuiteSparse,\n"
    "and is as a whole distributed under the GNU General Public License, version 2 or later."};

}  // namespace

const GlobalSmoother* ceres_smoother() { return &with_ceres; }
#else
const GlobalSmoother* ceres_smoother() { return nullptr; }
#endif

}  // namespace pliant
