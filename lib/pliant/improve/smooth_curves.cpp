#include "pliant/improve/smooth_curves.h"

#include <algorithm>
#include <array>
#include <map>
#include <queue>
#include <string>

#include "pliant/geometry/validity.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/ops/insert_point.h"
#include "pliant/ops/smooth_edge.h"

namespace pliant {
namespace {

constexpr double progress = 1e-3;  // a visit must lower the excess by this much (relative) for another one to follow

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Entry {
  double excess;
  TriangleId triangle;
  friend bool operator<(const Entry& a, const Entry& b) {
    return a.excess != b.excess ? a.excess < b.excess : a.triangle > b.triangle;
  }
};

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
  bool is_valid(TriangleId t) const {
    std::array<Point, net_size(max_degree)> net;
    mesh_.gather_points(t, net);
    return certify(mesh_.degree(), {net.data(), at(mesh_.net_size())}) == Validity::valid;
  }
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
      if (!smooth(entry.triangle)) continue;
      const double after = excess(entry.triangle);
      if (after < before * (1 - progress)) enqueue(entry.triangle);
      for (int e = 0; e < 3; ++e) {
        const HalfEdgeId g = mesh_.twin(half_edge(entry.triangle, e));
        if (g != none) enqueue(triangle_of(g));
      }
    }
  }

  /// Smooths the edges and the inner points of one element; true if anything moved.
  bool smooth(TriangleId t) {
    bool moved = false;
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e), g = mesh_.twin(h);
      if (g == none || mesh_.is_constrained(h)) continue;
      const SmoothGoal goal = is_valid(t) && is_valid(triangle_of(g)) ? SmoothGoal::improve : SmoothGoal::untangle;
      note(smooth_edge(mesh_, h, goal, options_.refit), moved);
    }
    if (mesh_.degree() > 2)
      note(smooth_interior(mesh_, t, is_valid(t) ? SmoothGoal::improve : SmoothGoal::untangle, options_.refit), moved);
    return moved;
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
