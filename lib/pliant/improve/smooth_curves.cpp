// lib/pliant/improve/smooth_curves.cpp: elements too curved, worst first (paper §5.3.4).
#include "pliant/improve/smooth_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "pliant/geometry/index.h"
#include "pliant/improve/smoothing/smoothing_moves.h"
#include "pliant/ops/build_triangle.h"
#include "pliant/ops/insert_point.h"

namespace pliant {
namespace {

constexpr double progress = 1e-2;  // an element whose excess fell by this much (relative) is visited again
constexpr int most_rounds = 10;    // of splits, or of straight triangles turned back
constexpr int child_rounds = 3;    // of smoothing the elements that a split makes
constexpr int most_searches = 4;   // of a valid element: they cost more than all the rest
constexpr int most_failures = 4;   // visits of a valid element that find nothing, whatever changes around it

struct Entry {
  double excess;
  TriangleId triangle;
  friend bool operator<(const Entry& a, const Entry& b) {
    return a.excess != b.excess ? a.excess < b.excess : a.triangle > b.triangle;
  }
};

class Smoother {
 public:
  Smoother(Mesh& mesh, const SmoothOptions& options)
      : mesh_(mesh), wanted_(options), options_(options), moves_(mesh, options_) {
    options_.vertices = options_.flips = options_.split = false;
  }

  SmoothOutcome run() {
    if (options_.progress != nullptr) options_.progress->start("smooth", "visits");
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t)
      if (mesh_.is_alive(t) && !moves_.is_fine(t)) suspects_.push_back(t);
    const std::size_t too_curved = suspects_.size();
    const std::vector<TriangleId> poor = suspects_;
    std::vector<Point> places;
    if (!poor.empty() && wanted_.keep_input != KeepInput::never) places = places_of_points();
    moves_.allow_searches(too_curved);
    work(suspects_);
    left_ = still_curved();
    if (!places.empty()) keep_input(poor, places);
    untangle_by_vertices();
    // Each option goes on from what the ones before it have left, and may not make it worse.
    if (wanted_.vertices) options_.vertices = true, work_on();
    if (wanted_.flips) options_.flips = true, work_on();
    if (wanted_.split) options_.split = true, split_on();
    if (!suspects_.empty()) {
      judge();
      if (is_changed_) mesh_.compact();
    }
    PassReport& report = outcome_.report;
    report.add("too_curved", static_cast<double>(too_curved));
    report.add("edges_smoothed", static_cast<double>(moves_.edges_smoothed));
    report.add("vertices_moved", static_cast<double>(moves_.vertices_moved));
    report.add("searches", static_cast<double>(moves_.searches));
    report.add("flips", static_cast<double>(moves_.flips));
    report.add("turned_back", static_cast<double>(turned_back_));
    report.add("splits", static_cast<double>(splits_));
    report.add("still_curved", static_cast<double>(outcome_.unmended.size()));
    report.add("still_curved_on_curves", static_cast<double>(on_curves_));
    report.add("needs_split", static_cast<double>(needs_split_));
    report.add("invalid", static_cast<double>(outcome_.invalid.size()));
    report.add("triangles", mesh_.triangle_count());
    for (const auto& [reason, times] : moves_.refusals) report.refuse(reason, times);
    for (const UnmendedElement& element : outcome_.unmended)
      report.refuse(describe(element.reason, {wanted_.vertices, wanted_.flips, wanted_.split}), element.place);
    return std::move(outcome_);
  }

 private:
  bool has_constrained_edge(TriangleId t) const {
    for (int e = 0; e < 3; ++e)
      if (mesh_.is_constrained(half_edge(t, e))) return true;
    return false;
  }

  /// Visits these elements, and what their change makes worth a visit, until nothing improves.
  void work(std::span<const TriangleId> elements) {
    if (elements.empty()) return;
    visits_.assign(index(mesh_.triangle_slots()), 0);
    last_.assign(index(mesh_.triangle_slots()), 0);
    searches_.resize(index(mesh_.triangle_slots()), 0);
    changed_.resize(index(mesh_.triangle_slots()), 0);
    failed_.resize(index(mesh_.triangle_slots()), 0);
    failures_.resize(index(mesh_.triangle_slots()), 0);
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

  /// Of what is left, all that has become allowed; and straight triangles turned back.
  void work_on() {
    is_guarded_ = false;
    if (!left_.empty()) {
      guard();
      forget_failures();
      work(left_);
    }
    for (int round = 0; round < most_rounds && turn_back(); ++round) work(suspects_);
    left_ = still_curved();
  }
  /// Where a vertex is in a wrong place no place of its edges' points helps: what is invalid is worth any means.
  void untangle_by_vertices() {
    std::vector<TriangleId> invalid;
    for (const TriangleId t : left_)
      if (!is_valid(mesh_, t)) invalid.push_back(t);
    if (invalid.empty()) return;
    options_.vertices = options_.flips = true;
    guard();
    forget_failures();
    work(invalid);
    for (int round = 0; round < most_rounds && turn_back(); ++round) work(suspects_);
    options_.vertices = options_.flips = false;
    left_ = still_curved();
  }
  void split_on() {
    if (left_.empty()) return;
    is_guarded_ = false;
    guard();
    for (int round = 0; round < most_rounds && !left_.empty() && split_edges(left_); ++round) {
      work(split_off_);
      left_ = still_curved();
    }
  }
  /// Neither the least shape nor the least scaled Jacobian of the mesh falls from here on.
  void guard() {
    if (is_guarded_) return;
    moves_.guard(least_quality_of_mesh(mesh_, left_));
    is_guarded_ = true;
  }

  void note_changed(std::span<const TriangleId> elements) {
    changed_.resize(index(mesh_.triangle_slots()), 0);
    ++clock_;
    for (const TriangleId t : elements) {
      changed_[index(t)] = clock_;
      unsplit_.erase(t);
    }
  }
  /// Has anything around the element changed since its last visit failed?
  bool is_worth_a_visit(TriangleId t) const {
    if (failed_[index(t)] == 0) return true;
    Star star;
    for (int c = 0; c < 3; ++c) {
      find_star(mesh_, mesh_.corner(t, c), star);
      for (const HalfEdgeId h : star.outgoing)
        if (changed_[index(triangle_of(h))] > failed_[index(t)]) return true;
    }
    return false;
  }
  /// A new option may help where the ones before it did not.
  void forget_failures() {
    std::fill(failed_.begin(), failed_.end(), 0);
    std::fill(failures_.begin(), failures_.end(), 0);
    std::fill(searches_.begin(), searches_.end(), 0);
  }

  /// Turns straight triangles back; true if any was.
  bool turn_back() {
    const std::size_t before = suspects_.size();
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
      if (!mesh_.is_alive(t) || !moves_.is_turned_over(t)) continue;
      guard();
      moves_.forget_touched();
      if (!moves_.turn_back(t)) continue;
      ++turned_back_;
      note_changed(moves_.touched());
      suspects_.insert(suspects_.end(), moves_.touched().begin(), moves_.touched().end());
    }
    is_changed_ = is_changed_ || suspects_.size() > before;
    return suspects_.size() > before;
  }

  void visit(TriangleId t, double before) {
    moves_.forget_touched();
    bool changed = moves_.smooth_edges(t);
    const auto is_mended = [&] { return moves_.movable_excess(t) <= std::max(1.0, before * (1 - progress)); };
    if (options_.flips && before >= tangled_excess && !is_mended()) changed = moves_.flip_edges(t) || changed;
    if (options_.vertices && !is_mended()) changed = moves_.move_vertices(t) || changed;
    // A valid element whose straight triangle is turned over is for flips and refinement: no place of its points helps.
    const auto is_worth_a_search = [&] {
      return before >= tangled_excess || (!moves_.is_turned_over(t) && searches_[index(t)]++ < most_searches);
    };
    if (!changed && is_worth_a_search()) changed = moves_.search_places(t);
    if (!changed) {
      last_[index(t)] = before;
      failed_[index(t)] = clock_;
      ++failures_[index(t)];
      return;
    }
    is_changed_ = true;
    std::vector<TriangleId> touched = moves_.touched();
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    suspects_.insert(suspects_.end(), touched.begin(), touched.end());
    note_changed(touched);
    for (const TriangleId u : touched) {
      const double excess = moves_.movable_excess(u), last = last_[index(u)];
      if (excess > 1 && std::fabs(excess - last) > progress * last) queue_.push({excess, u});
    }
    last_[index(t)] = moves_.movable_excess(t);
  }

  std::vector<TriangleId> still_curved() const {
    std::vector<TriangleId> left;
    for (const TriangleId t : suspects_)
      if (!moves_.is_fine(t)) left.push_back(t);
    return left;
  }

  // -- the mesh as it was

  std::vector<Point> places_of_points() const {
    std::vector<Point> places;
    for (PointId p = 0; p < mesh_.point_slots(); ++p) places.push_back(mesh_.point(p));
    return places;
  }
  /// So far points have moved, and nothing else has changed.
  void keep_input(const std::vector<TriangleId>& poor, const std::vector<Point>& places) {
    const auto matters = [this](TriangleId t) {
      return wanted_.keep_input == KeepInput::where_curved || !is_valid(mesh_, t);
    };
    if (std::none_of(left_.begin(), left_.end(), matters)) return;
    outcome_.input.emplace(mesh_);
    for (PointId p = 0; p < mesh_.point_slots(); ++p) outcome_.input->set_point(p, places[index(p)]);
    std::vector<std::pair<double, TriangleId>> others;
    const SmoothingMoves then(*outcome_.input, options_);
    for (const TriangleId t : poor)
      if (!std::binary_search(left_.begin(), left_.end(), t)) others.emplace_back(-then.excess(t), t);
    std::sort(others.begin(), others.end());
    outcome_.input_poor = left_;
    for (const auto& [excess, t] : others) outcome_.input_poor.push_back(t);
  }

  // -- splits of edges on curves

  enum class Split { useless, makes_others_worse, helps };

  /// Splits an edge of the element that is on a curve, smooths what comes of it, and tells whether the worst of it is
  /// better than the worst there was, and at least as good as what is guarded. Undone unless it is and `keep` is set.
  Split try_split(TriangleId t, bool keep) {
    Split result = Split::useless;
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
      if (!(now < before * (1 - progress))) continue;
      if (!moves_.keeps(moves_.quality_of(children), quality)) {
        result = Split::makes_others_worse;
        continue;
      }
      if (!keep) return Split::helps;
      trial.commit();
      ++splits_;
      is_changed_ = true;
      split_off_.insert(split_off_.end(), children.begin(), children.end());
      split_off_.insert(split_off_.end(), moves_.touched().begin(), moves_.touched().end());
      return Split::helps;
    }
    return result;
  }
  /// Splits what splitting helps, of elements that have changed since it did not.
  bool split_edges(const std::vector<TriangleId>& elements) {
    split_off_.clear();
    for (const TriangleId t : elements)
      if (!unsplit_.contains(t) && !moves_.is_fine(t) && try_split(t, true) != Split::helps) unsplit_.insert(t);
    suspects_.insert(suspects_.end(), split_off_.begin(), split_off_.end());
    note_changed(split_off_);
    const bool any = !split_off_.empty();
    split_off_.insert(split_off_.end(), elements.begin(), elements.end());  // what is beside them may help these
    return any;
  }

  // -- what is left

  void judge() {
    // Of a mesh that no option made guard, what is left is the floor: as strict or stricter, and nothing to look for.
    if (!is_guarded_) moves_.guard(least_quality(mesh_, left_));
    for (const TriangleId t : left_) {
      UnmendedElement element = explain_unmended(mesh_, t);
      if (element.reason != Unmended::smooth_corner) {
        const Split split = effect_of_split(t);
        if (split == Split::helps) element.reason = Unmended::needs_split;
        if (split == Split::makes_others_worse) element.reason = Unmended::needs_refinement;
      }
      outcome_.unmended.push_back(element);
      if (!is_valid(mesh_, t)) outcome_.invalid.push_back(t);
      on_curves_ += has_constrained_edge(t);
      needs_split_ += element.reason == Unmended::needs_split;
    }
  }
  Split effect_of_split(TriangleId t) {
    if (!has_constrained_edge(t)) return Split::useless;
    const auto counts = std::tuple(moves_.edges_smoothed, moves_.refusals);
    const Split effect = try_split(t, false);
    std::tie(moves_.edges_smoothed, moves_.refusals) = counts;
    return effect;
  }

  Mesh& mesh_;
  const SmoothOptions& wanted_;
  SmoothOptions options_;  // what is allowed so far
  SmoothingMoves moves_;
  std::priority_queue<Entry> queue_;
  std::vector<TriangleId> suspects_;               // all that were too curved or have been changed: no other one can be
  std::vector<TriangleId> left_;                   // those of them that are too curved
  std::vector<TriangleId> split_off_;              // what the splits of this round have made or changed
  std::set<TriangleId> unsplit_;                   // elements that a split does not help, as they are
  std::vector<int> visits_, searches_, failures_;  // of each element; the last two as long as no option is added
  std::vector<long> changed_, failed_;  // by the clock, when an element was last changed, or visited in vain; 0: never
  std::vector<double> last_;            // excess after the last visit; 0: none
  SmoothOutcome outcome_;
  long clock_ = 1, visited_ = 0, turned_back_ = 0, splits_ = 0, on_curves_ = 0, needs_split_ = 0;
  bool is_changed_ = false, is_guarded_ = false;
};

}  // namespace

SmoothOutcome smooth_curves(Mesh& mesh, const SmoothOptions& options) { return Smoother(mesh, options).run(); }

}  // namespace pliant
