#include "pliant/improve/smooth_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <map>
#include <queue>
#include <span>
#include <string>

#include "pliant/mesh/check_mesh.h"
#include "pliant/ops/insert_point.h"
#include "pliant/ops/smooth_edge.h"

namespace pliant {
namespace {

constexpr double progress = 1e-2;  // a visit must lower the excess by this much (relative) for another one to follow

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Entry {
  double excess;
  TriangleId triangle;
  friend bool operator<(const Entry& a, const Entry& b) {
    return a.excess != b.excess ? a.excess < b.excess : a.triangle > b.triangle;
  }
};

using Way = std::function<Refusal()>;  // of smoothing an edge or the inside of an element

class Smoother {
 public:
  Smoother(Mesh& mesh, const SmoothOptions& options) : mesh_(mesh), options_(options) {}

  SmoothOutcome run() {
    visits_.assign(at(mesh_.triangle_slots()), 0);
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) enqueue(t);
    const auto too_curved = static_cast<double>(queue_.size());
    work();
    if (options_.split) {
      split_constrained();
      work();
    }
    mesh_.compact();
    SmoothOutcome outcome;
    const InvalidElements left = find_invalid(mesh_);
    outcome.invalid = left.invalid;
    outcome.invalid.insert(outcome.invalid.end(), left.degenerate.begin(), left.degenerate.end());
    PassReport& report = outcome.report;
    report.add("too_curved", too_curved);
    report.add("edges_smoothed", static_cast<double>(smoothed_));
    report.add("splits", static_cast<double>(splits_));
    long curved = 0, on_curve = 0;
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
      if (excess(t) <= 1) continue;
      ++curved;
      if (has_constrained_edge(t)) ++on_curve;
    }
    report.add("still_curved", static_cast<double>(curved));
    report.add("still_curved_on_curves", static_cast<double>(on_curve));
    report.add("invalid", static_cast<double>(outcome.invalid.size()));
    report.add("triangles", mesh_.triangle_count());
    for (const auto& [reason, times] : refusals_) report.refuse(reason, times);
    return outcome;
  }

 private:
  double excess(TriangleId t) const {
    std::array<Point, net_size(max_degree)> net;
    mesh_.gather_points(t, net);
    return curvature_excess(mesh_.degree(), {net.data(), at(mesh_.net_size())}, options_.bounds);
  }
  bool is_valid(TriangleId t) const { return certify_element(mesh_, t) == Validity::valid; }
  bool has_constrained_edge(TriangleId t) const {
    for (int e = 0; e < 3; ++e)
      if (mesh_.is_constrained(half_edge(t, e))) return true;
    return false;
  }
  void enqueue(TriangleId t) {
    const double now = excess(t);
    if (now > 1) queue_.push({now, t});
  }

  void work() {
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (visits_[at(entry.triangle)] >= options_.max_sweeps) continue;
      const double before = excess(entry.triangle);
      if (before <= 1) continue;
      if (before < entry.excess) {  // better than when it was queued: its turn comes later
        queue_.push({before, entry.triangle});
        continue;
      }
      ++visits_[at(entry.triangle)];
      std::array<double, 3> neighbours{};
      for (int e = 0; e < 3; ++e) neighbours[at(e)] = excess_across(half_edge(entry.triangle, e));
      if (!smooth(entry.triangle)) continue;
      const double after = excess(entry.triangle);
      if (after < before * (1 - progress)) enqueue(entry.triangle);
      for (int e = 0; e < 3; ++e)
        if (std::abs(excess_across(half_edge(entry.triangle, e)) - neighbours[at(e)]) > progress * neighbours[at(e)])
          enqueue(triangle_of(mesh_.twin(half_edge(entry.triangle, e))));
    }
  }
  double excess_across(HalfEdgeId h) const { return mesh_.twin(h) == none ? 0 : excess(triangle_of(mesh_.twin(h))); }

  /// Smooths the edges and the inner points of one element; true if anything moved.
  bool smooth(TriangleId t) {
    if (!is_valid(t)) return untangle(t);
    bool moved = false;
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e), g = mesh_.twin(h);
      if (g == none || mesh_.is_constrained(h) || !is_valid(triangle_of(g))) continue;
      const std::array<TriangleId, 2> pair{t, triangle_of(g)};
      const auto improve = [&] { return smooth_edge(mesh_, h, SmoothGoal::improve, options_.refit); };
      const auto half = [&] { return straighten_edge(mesh_, h, 0.5, options_.refit); };
      const auto straight = [&] { return straighten_edge(mesh_, h, 0, options_.refit); };
      note(take_best(pair, {improve, half, straight}), moved);
    }
    if (mesh_.degree() <= 2) return moved;
    const std::array<TriangleId, 1> one{t};
    const auto improve = [&] { return smooth_interior(mesh_, t, SmoothGoal::improve, options_.refit); };
    const auto blend = [&] { return blend_interior(mesh_, t, options_.refit); };
    note(take_best(one, {improve, blend}), moved);
    return moved;
  }

  /// Makes an element valid by one of its edges or by its inner points alone, if any of them can do so; else moves
  /// all of them towards validity. No valid neighbour becomes invalid: what tangles must not spread.
  bool untangle(TriangleId t) {
    std::vector<Way> ways;
    if (mesh_.degree() > 2) {
      ways.push_back([this, t] { return blend_interior(mesh_, t, options_.refit); });
      ways.push_back([this, t] { return smooth_interior(mesh_, t, SmoothGoal::untangle, options_.refit); });
    }
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e);
      if (mesh_.twin(h) == none || mesh_.is_constrained(h)) continue;
      for (const double keep : {0.5, 0.0})
        ways.push_back([this, h, keep] { return straighten_edge(mesh_, h, keep, options_.refit); });
      ways.push_back([this, h] { return smooth_edge(mesh_, h, SmoothGoal::untangle, options_.refit); });
    }
    bool moved = false;
    for (const bool at_once : {true, false})
      for (const Way& way : ways) {
        const int before = count_invalid_across(t);
        Transaction trial(mesh_);
        const Refusal outcome = way();
        if (outcome == Refusal::done && (count_invalid_across(t) > before || (at_once && !is_valid(t)))) continue;
        if (!at_once || outcome == Refusal::done) note(outcome, moved);
        if (outcome != Refusal::done) continue;
        trial.commit();
        if (is_valid(t)) return true;
      }
    return moved;
  }
  int count_invalid_across(TriangleId t) const {
    int count = 0;
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId g = mesh_.twin(half_edge(t, e));
      count += g != none && !is_valid(triangle_of(g));
    }
    return count;
  }

  /// Tries each way of smoothing, and takes the one that leaves the elements least curved, if that is less than now.
  Refusal take_best(std::span<const TriangleId> elements, std::initializer_list<Way> ways) {
    const auto worst = [&] {
      double most = 0;
      for (const TriangleId t : elements) most = std::max(most, excess(t));
      return most;
    };
    double least = worst() * (1 - progress);
    const Way* best = nullptr;
    Refusal refusal = Refusal::would_invert;
    for (const auto& way : ways) {
      Transaction trial(mesh_);
      const Refusal outcome = way();
      if (outcome != Refusal::done) {
        refusal = outcome;
        continue;
      }
      const double now = worst();
      if (now < least) least = now, best = &way;
    }
    return best ? (*best)() : refusal;
  }

  void note(Refusal refusal, bool& moved) {
    if (refusal == Refusal::done) {
      ++smoothed_;
      moved = true;
    } else {
      ++refusals_[describe(refusal)];
    }
  }

  /// Splits the constrained edge of each element that smoothing could not mend.
  void split_constrained() {
    for (TriangleId t = 0, count = mesh_.triangle_slots(); t < count; ++t) {
      if (excess(t) <= 1) continue;
      for (int e = 0; e < 3; ++e) {
        const HalfEdgeId h = half_edge(t, e);
        if (!mesh_.is_constrained(h)) continue;
        if (split_edge(mesh_, h, 0.5).refusal == Refusal::done) ++splits_;
        break;
      }
    }
    visits_.assign(at(mesh_.triangle_slots()), 0);
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) enqueue(t);
  }

  Mesh& mesh_;
  const SmoothOptions& options_;
  std::priority_queue<Entry> queue_;
  std::vector<int> visits_;
  std::map<std::string, long> refusals_;
  long smoothed_ = 0, splits_ = 0;
};

}  // namespace

SmoothOutcome smooth_curves(Mesh& mesh, const SmoothOptions& options) { return Smoother(mesh, options).run(); }

}  // namespace pliant
