// lib/pliant/improve/smooth_curves.cpp: edges first, then one option after the other; what is left, and why.
#include "pliant/improve/smooth_curves.h"

#include <algorithm>
#include <utility>

#include "pliant/geometry/index.h"
#include "pliant/improve/smoothing/curve_splits.h"
#include "pliant/improve/smoothing/smoothing_moves.h"
#include "pliant/improve/smoothing/worst_first.h"
#include "pliant/mesh/turned_over.h"
#include "pliant/ops/build_triangle.h"

namespace pliant {
namespace {

constexpr int most_rounds = 10;  // rounds of splits, or of straight triangles turned back

/// Allows one option after the other, and judges what is left at the end.
class Smoother {
 public:
  Smoother(Mesh& mesh, const SmoothOptions& options)
      : mesh_(mesh),
        wanted_(options),
        options_(options),
        moves_(mesh, options_),
        visits_(mesh, moves_, options_),
        splits_(mesh, moves_) {
    options_.vertices = options_.flips = options_.split = false;
  }

  SmoothOutcome run() {
    if (options_.progress != nullptr) options_.progress->start("smooth", "visits");
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t)
      if (mesh_.is_alive(t) && !moves_.is_fine(t)) visits_.add_suspect(t);
    const std::vector<TriangleId> poor(visits_.suspects().begin(), visits_.suspects().end());
    std::vector<Point> places;
    if (!poor.empty() && wanted_.keep_input != KeepInput::never) places = places_of_points();
    moves_.allow_searches(poor.size());
    visits_.run(visits_.suspects());
    left_ = still_curved();
    if (!places.empty()) keep_input(poor, places);
    untangle_by_vertices();
    // Each option goes on from what the ones before it have left, and may not make it worse.
    if (wanted_.vertices) options_.vertices = true, work_on();
    if (wanted_.flips) options_.flips = true, work_on();
    if (wanted_.split) options_.split = true, split_on();
    if (!visits_.suspects().empty()) {
      judge();
      if (visits_.has_changed()) mesh_.compact();
    }
    write_report(poor.size());
    return std::move(outcome_);
  }

 private:
  bool has_constrained_edge(TriangleId t) const {
    for (int e = 0; e < 3; ++e)
      if (mesh_.is_constrained(half_edge(t, e))) return true;
    return false;
  }
  std::vector<TriangleId> still_curved() const {
    std::vector<TriangleId> left;
    for (const TriangleId t : visits_.suspects())
      if (!moves_.is_fine(t)) left.push_back(t);
    return left;
  }

  // -- the options in turn

  /// Visits what is left, with all that is allowed by now, and turns straight triangles back.
  void work_on() {
    is_guarded_ = false;
    if (!left_.empty()) {
      guard();
      visits_.forget_failures();
      visits_.run(left_);
    }
    turn_back_and_visit();
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
    visits_.forget_failures();
    visits_.run(invalid);
    turn_back_and_visit();
    options_.vertices = options_.flips = false;
    left_ = still_curved();
  }
  void split_on() {
    if (left_.empty()) return;
    is_guarded_ = false;
    guard();
    for (int round = 0; round < most_rounds && !left_.empty(); ++round) {
      std::vector<TriangleId> again = splits_.split(left_, visits_);
      if (again.empty()) break;
      visits_.add_changed(again);
      again.insert(again.end(), left_.begin(), left_.end());  // the splits beside them may help these
      visits_.run(again);
      left_ = still_curved();
    }
  }
  /// Neither the least shape nor the least scaled Jacobian of the mesh falls from here on.
  void guard() {
    if (is_guarded_) return;
    moves_.guard(least_quality_of_mesh(mesh_, left_));
    is_guarded_ = true;
  }

  void turn_back_and_visit() {
    for (int round = 0; round < most_rounds && turn_back(); ++round) visits_.run(visits_.suspects());
  }
  /// Turns straight triangles back; true if any was.
  bool turn_back() {
    bool any = false;
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) {
      if (!mesh_.is_alive(t) || !is_turned_over(mesh_, t)) continue;
      guard();
      moves_.forget_touched();
      if (!moves_.turn_back(t)) continue;
      ++turned_back_;
      visits_.add_changed(moves_.touched());
      any = true;
    }
    return any;
  }

  // -- the mesh as it was

  std::vector<Point> places_of_points() const {
    std::vector<Point> places;
    for (PointId p = 0; p < mesh_.point_slots(); ++p) places.push_back(mesh_.point(p));
    return places;
  }
  /// Requires that nothing but the places of points has changed so far.
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

  // -- what is left

  void judge() {
    // Where no option has set a guard, the worst of what is left is the floor that a split must keep. It is at least as
    // strict as the floor of the whole mesh, and need not be looked for.
    if (!is_guarded_) moves_.guard(least_quality(mesh_, left_));
    for (const TriangleId t : left_) {
      UnmendedElement element = explain_unmended(mesh_, t);
      const bool is_on_curve = has_constrained_edge(t);
      if (is_on_curve && element.reason != Unmended::smooth_corner) {
        const CurveSplits::Effect effect = splits_.effect_on(t);
        if (effect == CurveSplits::Effect::helps) element.reason = Unmended::needs_split;
        if (effect == CurveSplits::Effect::makes_others_worse) element.reason = Unmended::needs_refinement;
      }
      outcome_.unmended.push_back(element);
      if (!is_valid(mesh_, t)) outcome_.invalid.push_back(t);
      on_curves_ += is_on_curve;
      needs_split_ += element.reason == Unmended::needs_split;
    }
  }
  void write_report(std::size_t too_curved) {
    PassReport& report = outcome_.report;
    report.add("too_curved", static_cast<double>(too_curved));
    report.add("edges_smoothed", static_cast<double>(moves_.edges_smoothed));
    report.add("vertices_moved", static_cast<double>(moves_.vertices_moved));
    report.add("searches", static_cast<double>(moves_.searches));
    report.add("flips", static_cast<double>(moves_.flips));
    report.add("turned_back", static_cast<double>(turned_back_));
    report.add("splits", static_cast<double>(splits_.count()));
    report.add("still_curved", static_cast<double>(outcome_.unmended.size()));
    report.add("still_curved_on_curves", static_cast<double>(on_curves_));
    report.add("needs_split", static_cast<double>(needs_split_));
    report.add("invalid", static_cast<double>(outcome_.invalid.size()));
    report.add("triangles", mesh_.triangle_count());
    for (const auto& [reason, times] : moves_.refusals) report.refuse(reason, times);
    for (const UnmendedElement& element : outcome_.unmended)
      report.refuse(describe(element.reason, {wanted_.vertices, wanted_.flips, wanted_.split}), element.place);
  }

  Mesh& mesh_;
  const SmoothOptions& wanted_;
  SmoothOptions options_;  // what is allowed so far
  SmoothingMoves moves_;
  WorstFirst visits_;
  CurveSplits splits_;
  std::vector<TriangleId> left_;  // the suspects that are too curved
  SmoothOutcome outcome_;
  long turned_back_ = 0, on_curves_ = 0, needs_split_ = 0;
  bool is_guarded_ = false;
};

}  // namespace

SmoothOutcome smooth_curves(Mesh& mesh, const SmoothOptions& options) { return Smoother(mesh, options).run(); }

}  // namespace pliant
