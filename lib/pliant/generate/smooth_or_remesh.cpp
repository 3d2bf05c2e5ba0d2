// lib/pliant/generate/smooth_or_remesh.cpp: smoothing, and where it leaves elements invalid, a new mesh of their
// regions.
#include "pliant/generate/smooth_or_remesh.h"

#include <string>
#include <utility>

#include "pliant/generate/remesh_patch.h"
#include "pliant/improve/smoothing/add_reports.h"

namespace pliant {
namespace {

std::string describe_replaced(std::size_t invalid, const RemeshPatchCounts& counts) {
  return "smoothing left " + std::to_string(invalid) + " elements invalid: " + std::to_string(counts.triangles_before) +
         " elements in " + std::to_string(counts.patches) + (counts.patches == 1 ? " region" : " regions") +
         " were replaced by " + std::to_string(counts.triangles_after) + " new ones";
}

}  // namespace

SmoothOutcome smooth_or_remesh(Mesh& mesh, const std::function<SmoothOutcome(Mesh&)>& smooth,
                               const RefitOptions& refit) {
  SmoothOutcome outcome = smooth(mesh);
  RemeshPatchCounts remeshed;
  if (!outcome.invalid.empty()) remeshed = remesh_invalid(mesh, refit);
  if (remeshed.patches > 0) {
    SmoothOutcome again = smooth(mesh);
    add_first_smoothing(outcome.report, again.report);
    again.report.notes.insert(again.report.notes.begin(), describe_replaced(outcome.invalid.size(), remeshed));
    outcome = std::move(again);
  }
  outcome.report.add("patches_remeshed", static_cast<double>(remeshed.patches));
  return outcome;
}

SmoothOutcome smooth_or_remesh(Mesh& mesh, const SmoothOptions& options) {
  return smooth_or_remesh(
      mesh, [&options](Mesh& each) { return smooth_curves(each, options); }, options.refit);
}

}  // namespace pliant
