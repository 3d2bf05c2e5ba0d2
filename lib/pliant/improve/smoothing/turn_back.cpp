// lib/pliant/improve/smoothing/turn_back.cpp: turns logical triangles back that are turned over, by vertices and flips.
#include <algorithm>
#include <array>
#include <functional>

#include "pliant/improve/smoothing/smoothing_moves.h"
#include "pliant/mesh/turned_over.h"
#include "pliant/ops/flip_edge.h"

namespace pliant {
namespace {

constexpr int smoothing_rounds = 3;  // times that the edges around a moved vertex are smoothed

/// Is the sorted list of excesses not worse than before? Excesses of elements that are fine count as 1, so these may
/// become less good.
bool is_no_worse(std::span<const double> now, std::span<const double> before) {
  for (std::size_t k = 0; k < now.size(); ++k) {
    const double a = std::max(1.0, now[k]), b = std::max(1.0, before[k]);
    if (a != b) return a < b;
  }
  return true;
}

}  // namespace

std::vector<double> SmoothingMoves::excesses_of(std::span<const TriangleId> elements) const {
  std::vector<double> excesses;
  for (const TriangleId t : elements) excesses.push_back(movable_excess(t));
  std::sort(excesses.begin(), excesses.end(), std::greater<>());
  return excesses;
}

bool SmoothingMoves::turn_back(TriangleId t) {
  if (options_.vertices)
    for (int c = 0; c < 3; ++c)
      if (turn_back_by_vertex(mesh_.corner(t, c))) return true;
  if (options_.flips)
    for (int e = 0; e < 3; ++e)
      if (turn_back_by_flip(half_edge(t, e))) return true;
  return false;
}

/// Moves a vertex towards the best place of its straight star. Kept if fewer of the logical triangles around it are
/// turned over than before, and the elements are no worse, if need be after their edges are smoothed.
bool SmoothingMoves::turn_back_by_vertex(PointId v) {
  find_star(mesh_, v, star_);
  if (!star_.is_closed || is_on_curve(mesh_, star_)) return false;
  std::vector<TriangleId> star, region;
  for (const HalfEdgeId h : star_.outgoing) star.push_back(triangle_of(h));
  region = star;
  for (const HalfEdgeId h : star_.outgoing)
    if (const HalfEdgeId g = mesh_.twin(next(h)); g != none) region.push_back(triangle_of(g));
  std::sort(region.begin(), region.end());
  region.erase(std::unique(region.begin(), region.end()), region.end());
  const std::vector<HalfEdgeId> spokes = star_.outgoing;
  const Vector best = shift_of(v);
  const auto count_turned_over = [&] {
    int count = 0;
    for (std::size_t e = 0; e < trial_.count(); ++e) {
      const auto net = trial_.net(e);
      count += is_turned_over(net[0], net[1], net[2]);
    }
    return count;
  };
  trial_.capture(mesh_, star);
  const int turned_over = count_turned_over();
  const std::vector<double> before = excesses_of(region);
  const PatchQuality quality = quality_of(region);
  for (const bool straight : {true, false})
    for (const double share : {1.0, 0.7, 0.5, 0.3}) {
      trial_.capture(mesh_, star);
      trial_.drag(v, share * best);
      if (count_turned_over() >= turned_over) continue;
      for (const HalfEdgeId h : spokes)
        if (straight) trial_.straighten(mesh_, h, 0);
      Transaction attempt(mesh_);
      const std::size_t touched = touched_.size();
      if (trial_.apply(mesh_, options_.refit, before.front() < tangled_excess) != Outcome::done) continue;
      const auto is_kept = [&] {
        const std::vector<double> now = excesses_of(region);
        return count_tangled(now) <= count_tangled(before) && is_no_worse(now, before) &&
               keeps(quality_of(region), quality);
      };
      const long smoothed = edges_smoothed;
      bool kept = is_kept();
      for (int round = 0; !kept && round < smoothing_rounds; ++round) {
        bool changed = false;
        for (const TriangleId t : star)
          if (!is_fine(t)) changed = smooth_edges(t) || changed;
        if (!changed) break;
        kept = is_kept();
      }
      touched_.resize(touched);
      if (!kept) edges_smoothed = smoothed;
      if (!kept) continue;
      attempt.commit();
      touched_.insert(touched_.end(), region.begin(), region.end());
      return true;
    }
  return false;
}

bool SmoothingMoves::turn_back_by_flip(HalfEdgeId h) {
  if (mesh_.twin(h) == none || mesh_.is_constrained(h)) return false;
  const std::array<TriangleId, 2> pair{triangle_of(h), triangle_of(mesh_.twin(h))};
  const std::vector<double> before = excesses_of(pair);
  const PatchQuality quality = quality_of(pair);
  Transaction trial(mesh_);
  if (flip_edge(mesh_, h, options_.refit) != Outcome::done) return false;  // both new straight triangles are positive
  const std::vector<double> now = excesses_of(pair);
  if (count_tangled(now) > count_tangled(before) || !is_no_worse(now, before)) return false;
  if (!keeps(quality_of(pair), quality)) return false;
  trial.commit();
  touched_.insert(touched_.end(), pair.begin(), pair.end());
  ++flips;
  return true;
}

}  // namespace pliant
