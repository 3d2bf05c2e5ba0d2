// lib/pliant/improve/smoothing/curve_splits.cpp: a split, smoothed at once, against what was there before.
#include "pliant/improve/smoothing/curve_splits.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "pliant/ops/insert_point.h"

namespace pliant {
namespace {

constexpr double least_fall = 1e-2;  // share by which a split must lower the worst excess to help
constexpr int child_rounds = 3;      // times that each element made by a split is smoothed before it is judged

}  // namespace

/// Splits an edge of the element that is on a curve and smooths the new elements. That helps if the worst of them is
/// better than the worst element there was, and all are at least as good as what is guarded. Undone unless it helps and
/// `keeps` is set.
CurveSplits::Effect CurveSplits::try_split(TriangleId t, bool keeps) {
  Effect result = Effect::useless;
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId h = half_edge(t, e), g = mesh_.twin(h);
    if (!mesh_.is_constrained(h)) continue;
    const double before = std::max(moves_.excess(t), g == none ? 1.0 : moves_.excess(triangle_of(g)));
    const std::array<TriangleId, 2> sides{t, g == none ? t : triangle_of(g)};
    const auto quality = moves_.quality_of(std::span(sides).first(g == none ? 1 : 2));
    moves_.forget_touched();
    Transaction trial(mesh_);
    const InsertResult made = split_edge(mesh_, h, 0.5);
    if (made.outcome != Outcome::done) continue;
    Star star;
    find_star(mesh_, made.vertex, star);
    std::vector<TriangleId> children;
    for (const HalfEdgeId out : star.outgoing) children.push_back(triangle_of(out));
    for (int round = 0; round < child_rounds; ++round)
      for (const TriangleId child : children)
        if (!moves_.is_fine(child)) moves_.smooth_edges(child);
    double now = 0;
    for (const TriangleId child : children) now = std::max(now, moves_.excess(child));
    if (!(now < before * (1 - least_fall))) continue;
    if (!moves_.keeps(moves_.quality_of(children), quality)) {
      result = Effect::makes_others_worse;
      continue;
    }
    if (!keeps) return Effect::helps;
    trial.commit();
    ++count_;
    changed_.insert(changed_.end(), children.begin(), children.end());
    changed_.insert(changed_.end(), moves_.touched().begin(), moves_.touched().end());
    return Effect::helps;
  }
  return result;
}

std::vector<TriangleId> CurveSplits::split(std::span<const TriangleId> elements, const WorstFirst& visits) {
  changed_.clear();
  for (const TriangleId t : elements) {
    const auto failed = failed_.find(t);
    if (failed != failed_.end() && !visits.has_changed_since(t, failed->second)) continue;
    if (!moves_.is_fine(t) && try_split(t, true) != Effect::helps) failed_[t] = visits.now();
  }
  return changed_;
}

CurveSplits::Effect CurveSplits::effect_on(TriangleId t) {
  const auto counts = std::tuple(moves_.edges_smoothed, moves_.refusals);
  const Effect effect = try_split(t, false);
  std::tie(moves_.edges_smoothed, moves_.refusals) = counts;
  return effect;
}

}  // namespace pliant
