// lib/pliant/improve/smoothing/worst_first.cpp: a queue by excess, and which elements are worth another visit.
#include "pliant/improve/smoothing/worst_first.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/mesh/turned_over.h"

namespace pliant {
namespace {

constexpr double progress = 1e-2;  // an element whose excess has changed by this share is visited again
constexpr int most_searches = 4;   // for one valid element: searches cost more than all the rest
constexpr int most_failures = 4;   // a valid element is given up after so many visits that found nothing to change

}  // namespace

void WorstFirst::run(std::span<const TriangleId> elements) {
  if (elements.empty()) return;
  const std::size_t slots = index(mesh_.triangle_slots());
  visits_.assign(slots, 0);
  last_.assign(slots, 0);
  searches_.resize(slots, 0);
  changed_.resize(slots, 0);
  failed_.resize(slots, 0);
  failures_.resize(slots, 0);
  for (const TriangleId t : elements)
    if (const double excess = moves_.movable_excess(t); excess > 1 && is_worth_a_visit(t)) queue_.push({excess, t});
  while (!queue_.empty()) {
    const Entry entry = queue_.top();
    queue_.pop();
    const TriangleId t = entry.triangle;
    if (visits_[index(t)] >= options_.max_sweeps) continue;
    const double before = moves_.movable_excess(t);
    if (before <= 1 || (before < tangled_excess && failures_[index(t)] >= most_failures)) continue;
    if (before < entry.excess) {  // better than when it was queued: its turn comes later
      queue_.push({before, t});
      continue;
    }
    ++visits_[index(t)];
    if (options_.progress != nullptr) options_.progress->count(++visited_);
    visit(t, before);
  }
  std::sort(suspects_.begin(), suspects_.end());
  suspects_.erase(std::unique(suspects_.begin(), suspects_.end()), suspects_.end());
}

void WorstFirst::forget_failures() {
  std::fill(failed_.begin(), failed_.end(), 0);
  std::fill(failures_.begin(), failures_.end(), 0);
  std::fill(searches_.begin(), searches_.end(), 0);
}

void WorstFirst::add_changed(std::span<const TriangleId> elements) {
  if (elements.empty()) return;
  has_changed_ = true;
  suspects_.insert(suspects_.end(), elements.begin(), elements.end());
  changed_.resize(index(mesh_.triangle_slots()), 0);
  ++clock_;
  for (const TriangleId t : elements) changed_[index(t)] = clock_;
}

/// Has anything around the element changed since its last visit in vain?
bool WorstFirst::is_worth_a_visit(TriangleId t) const {
  if (failed_[index(t)] == 0) return true;
  Star star;
  for (int c = 0; c < 3; ++c) {
    find_star(mesh_, mesh_.corner(t, c), star);
    for (const HalfEdgeId h : star.outgoing)
      if (changed_[index(triangle_of(h))] > failed_[index(t)]) return true;
  }
  return false;
}

/// Tries all that the options allow, what costs little first; false if no change was kept.
bool WorstFirst::change(TriangleId t, double before) {
  bool changed = moves_.smooth_edges(t);
  const auto is_mended = [&] { return moves_.movable_excess(t) <= std::max(1.0, before * (1 - progress)); };
  if (options_.flips && before >= tangled_excess && !is_mended()) changed = moves_.flip_edges(t) || changed;
  if (options_.vertices && !is_mended()) changed = moves_.move_vertices(t) || changed;
  // A valid element whose straight triangle is turned over is for flips and refinement: no place of its points helps.
  const auto is_worth_a_search = [&] {
    return before >= tangled_excess || (!is_turned_over(mesh_, t) && searches_[index(t)]++ < most_searches);
  };
  if (!changed && is_worth_a_search()) changed = moves_.search_places(t);
  return changed;
}

void WorstFirst::visit(TriangleId t, double before) {
  moves_.forget_touched();
  if (!change(t, before)) {
    last_[index(t)] = before;
    failed_[index(t)] = clock_;
    ++failures_[index(t)];
    return;
  }
  std::vector<TriangleId> touched = moves_.touched();
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  add_changed(touched);
  for (const TriangleId u : touched) {
    const double excess = moves_.movable_excess(u), last = last_[index(u)];
    if (excess > 1 && std::fabs(excess - last) > progress * last) queue_.push({excess, u});
  }
  last_[index(t)] = moves_.movable_excess(t);
}

}  // namespace pliant
