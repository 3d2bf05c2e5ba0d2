// lib/pliant/generate/refine_first_mesh.cpp: the first mesh of a boundary, refined to what it promises.
#include "pliant/generate/refine_first_mesh.h"

#include "pliant/improve/smoothing/share_bends.h"
#include "pliant/improve/smoothing/straighten_edges.h"

namespace pliant {
namespace {

// Flips during refinement lay a new edge straight if the straight place is off by less than this part of the length of
// the longest edge: all inner edges become straight in the end, where they can.
constexpr double straight_below = 0.05;

}  // namespace

PassReport refine_first_mesh(Mesh& mesh, const RefineOptions& options) {
  RefineOptions asked = options;
  if (!asked.goals) asked.goals = goals_of(mesh);
  if (!mesh.criteria.min_angle) mesh.criteria.min_angle = asked.goals->min_angle;
  asked.refit.straight_below = straight_below;
  PassReport report = refine(mesh, asked);
  if (options.progress != nullptr) options.progress->start("straighten");
  const StraightenCounts edges = straighten_edges(mesh);
  report.add("edges_straightened", static_cast<double>(edges.straightened));
  report.add("edges_left_curved", static_cast<double>(edges.left));
  report.add("elements_levelled", static_cast<double>(share_bends(mesh).levelled));
  return report;
}

}  // namespace pliant
