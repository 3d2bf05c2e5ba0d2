// lib/pliant/improve/coarsening/removal_chain.cpp: one removal after the other, as long as refine would attack.
#include "pliant/improve/coarsening/removal_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pliant/geometry/index.h"
#include "pliant/quality/element/element_quality.h"

namespace pliant {
namespace {

constexpr double least_shape = 0.25;  // the least shape that is asked of curved elements, whatever the least angle is
constexpr double least_part = 0.5;    // a removal leaves at least this share of the least shape that was there

void sort_unique(std::vector<TriangleId>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

double accepted_shape(const QualityGoals& goals) {
  const bool asks_size =
      goals.size || goals.size_field != none || goals.max_area < HUGE_VAL ||
      std::any_of(goals.face_area.begin(), goals.face_area.end(), [](double a) { return a < HUGE_VAL; });
  if (asks_size) return least_shape;
  const double angle = goals.min_angle * std::numbers::pi / 180, c = std::cos(angle);
  return std::max(least_shape, 4 * std::numbers::sqrt3 * std::sin(angle) * c / (2 + 4 * c * c));
}

RemovalChain::RemovalChain(Mesh& mesh, const Limits& limits, const std::vector<bool>& slated)
    : mesh_(mesh), limits_(limits), slated_(slated), forecast_(mesh, limits.goals, limits.curves, slated) {}

RemovalRefusal RemovalChain::foresee(PointId v, bool is_on_curve) {
  const RemovalRefusal refusal = forecast_.of(v, is_on_curve);
  if (refusal.reason != nullptr)
    decided_by_.insert(decided_by_.end(), forecast_.decided_by().begin(), forecast_.decided_by().end());
  return refusal;
}

RemovalRefusal RemovalChain::remove(PointId v, bool is_on_curve) {
  decided_by_.assign(1, v);
  if (limits_.uses_forecast)
    if (const RemovalRefusal refusal = foresee(v, is_on_curve); refusal.reason != nullptr) return refusal;
  Transaction transaction(mesh_);
  chained_.clear();
  around_.clear();
  along_curves_.clear();
  curves_.clear();
  attacked_.clear();
  worst_before_ = 1;
  error_ = integral_change_ = 0;
  RemovalRefusal refusal;
  for (PointId w = v; w != none;) {
    thread_local Star star;
    find_star(mesh_, w, star);
    const CurveRemoval removal = remove_one(w, w == v ? is_on_curve : pliant::is_on_curve(mesh_, star));
    if (removal.outcome != Outcome::done && w == v) refusal = {describe(removal.outcome)};
    if (removal.outcome != Outcome::done) break;
    chained_.push_back(w);
    error_ = std::max(error_, removal.error);
    integral_change_ = std::max(integral_change_, removal.integral_change);
    refusal = {nullptr, true};
    w = most_urgent(refusal.reason).vertex;
    if (chained_.size() == most_chained) break;
  }
  if (refusal.reason == nullptr && is_misshapen()) refusal = {"would be misshapen"};
  if (refusal.reason != nullptr) {
    note_corners(around_);
    return refusal;
  }
  if (before_first_) {
    transaction.roll_back();
    std::exchange(before_first_, nullptr)();
    return remove(v, is_on_curve);
  }
  transaction.commit();
  for (const CurveId c : curves_) forecast_.forget(c);
  return refusal;
}

CurveRemoval RemovalChain::remove_one(PointId v, bool is_on_curve) {
  find_star(mesh_, v, star_);
  link_.clear();
  for (const HalfEdgeId h : star_.outgoing) link_.push_back(mesh_.target(h));
  if (!star_.is_closed) link_.push_back(mesh_.apex(star_.outgoing.back()));  // pinched vertices are never removed
  changed_.clear();
  if (is_on_curve) {
    add_curve_neighbors(v);
    look_around();
  } else {
    for (const HalfEdgeId h : star_.outgoing) changed_.push_back(triangle_of(h));
  }
  note_corners(changed_);
  for (const TriangleId t : changed_) {
    if (!std::binary_search(around_.begin(), around_.end(), t))  // the chain itself has made those
      worst_before_ = std::min(worst_before_, shape_of(t));
    if (chained_.empty() && attack_reason(mesh_, t, limits_.goals)) attacked_.push_back(corners_of(t));
  }
  CurveRemoval removal;
  if (is_on_curve)
    removal = remove_curve_vertex(mesh_, v, limits_.curves, limits_.refit);
  else
    removal.outcome = remove_inner_vertex(mesh_, v, limits_.refit);
  if (removal.outcome != Outcome::done) return removal;
  is_on_curve ? look_around() : look_inside();
  for (const TriangleId t : changed_)  // flips that edges in the hole now want
    for (int e = 0; e < 3; ++e)
      if (wants_flip(edge_state(mesh_, half_edge(t, e)))) stack_.push_back(half_edge(t, e));
  around_.insert(around_.end(), changed_.begin(), changed_.end());
  legalize(mesh_, stack_, limits_.refit, counts_, -1, &around_);
  sort_unique(around_);
  return removal;
}

void RemovalChain::note_corners(std::span<const TriangleId> triangles) {
  for (const TriangleId t : triangles) {
    if (!mesh_.is_alive(t)) continue;
    for (int c = 0; c < 3; ++c) decided_by_.push_back(mesh_.corner(t, c));
  }
}

/// Collects the triangles around the link of what is removed.
void RemovalChain::look_around() {
  changed_.clear();
  for (const PointId w : link_) {
    find_star(mesh_, w, star_);
    for (const HalfEdgeId h : star_.outgoing) changed_.push_back(triangle_of(h));
  }
  sort_unique(changed_);
}

/// Collects the triangles that fill the hole: those with all corners on the link.
void RemovalChain::look_inside() {
  look_around();
  const auto is_outside = [this](PointId v) { return std::find(link_.begin(), link_.end(), v) == link_.end(); };
  std::erase_if(changed_, [&](TriangleId t) {
    return is_outside(mesh_.corner(t, 0)) || is_outside(mesh_.corner(t, 1)) || is_outside(mesh_.corner(t, 2));
  });
}

/// Adds the neighbours of v along its curve. The removal of a knot also moves vertices that are up to `degree` spans
/// away, and changes the error that the removal of other knots would make up to twice as far.
void RemovalChain::add_curve_neighbors(PointId v) {
  for (const HalfEdgeId h : star_.outgoing)
    if (mesh_.is_constrained(h)) curves_.push_back(mesh_.constraint_curve(mesh_.constraint(h)));
  chain_.assign(1, v);
  std::size_t first = 0, moved = 0;
  for (int k = 0; k <= 2 * mesh_.degree(); ++k) {
    if (k == mesh_.degree()) moved = chain_.size();
    for (const std::size_t last = chain_.size(); first < last; ++first) {
      const PointId w = chain_[first];
      find_star(mesh_, w, star_);
      for (const HalfEdgeId h : star_.outgoing)
        for (const HalfEdgeId side : {h, previous(h)}) {
          const PointId next = mesh_.origin(side) == w ? mesh_.target(side) : mesh_.origin(side);
          if (mesh_.is_constrained(side) && std::find(chain_.begin(), chain_.end(), next) == chain_.end())
            chain_.push_back(next);
        }
    }
  }
  link_.insert(link_.end(), chain_.begin() + 1, chain_.begin() + static_cast<std::ptrdiff_t>(moved));
  along_curves_.insert(along_curves_.end(), chain_.begin() + 1, chain_.end());
}

/// Which vertex to remove next so that refine attacks none of the elements around that it would not have attacked
/// before. No vertex if all is well, or if such an element has no slated corner. `reason` is why an element would be
/// attacked; it is left as it is if none would.
Culprit RemovalChain::most_urgent(const char*& reason) const {
  Culprit first;
  for (const TriangleId t : around_) {
    if (!mesh_.is_alive(t)) continue;
    const char* why = attack_reason(mesh_, t, limits_.goals);
    if (!why || std::find(attacked_.begin(), attacked_.end(), corners_of(t)) != attacked_.end()) continue;
    reason = why;
    const std::array<PointId, 3> corners{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
    const std::array<Point, 3> places{mesh_.point(corners[0]), mesh_.point(corners[1]), mesh_.point(corners[2])};
    const Culprit culprit = find_culprit(mesh_, corners, places, slated_);
    if (culprit.vertex == none) return culprit;
    first = std::min(first, culprit);
  }
  return first;
}

bool RemovalChain::is_misshapen() const {
  const double limit = std::min(worst_before_, std::max(limits_.accepted_shape, least_part * worst_before_));
  return std::any_of(around_.begin(), around_.end(),
                     [&](TriangleId t) { return mesh_.is_alive(t) && shape_of(t) < limit; });
}

RemovalChain::Corners RemovalChain::corners_of(TriangleId t) const {
  Corners corners{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
  std::sort(corners.begin(), corners.end());
  return corners;
}

double RemovalChain::shape_of(TriangleId t) const {
  std::array<Point, net_size(max_degree)> net;
  mesh_.gather_points(t, net);
  return curved_shape(mesh_.degree(), {net.data(), index(mesh_.net_size())});
}

}  // namespace pliant
