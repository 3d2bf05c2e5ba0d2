#include "pliant/improve/coarsen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "pliant/improve/independent_set.h"
#include "pliant/improve/legalize.h"
#include "pliant/improve/local_feature_size.h"
#include "pliant/improve/refine.h"
#include "pliant/mesh/hilbert_order.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/remove_point.h"
#include "pliant/quality/element_quality.h"

namespace pliant {
namespace {

constexpr double gradation = 0.7;     // Lipschitz bound of the wanted length
constexpr double least_shape = 0.25;  // a removal must not leave curved elements worse than this and than before
constexpr double growth = 1.8;        // of lengths in a round
constexpr int most_chained = 12;      // removals that may mend each other's elements
constexpr int most_rounds = 40;       // of choosing what stays

std::size_t at(int i) { return static_cast<std::size_t>(i); }

void sort_unique(std::vector<TriangleId>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

class Coarsener {
 public:
  Coarsener(Mesh& mesh, const CoarsenOptions& options) : mesh_(mesh), options_(options) {}

  PassReport run() {
    for (int round = 0; round < most_rounds; ++round) {
      const long before = inner_removals_ + curve_removals_;
      choose();
      remove_slated();
      if (inner_removals_ + curve_removals_ == before) break;
    }
    PassReport report = make_report();
    mesh_.compact();
    return report;
  }

 private:
  using Corners = std::array<PointId, 3>;

  /// What stays. What could not go in the last round comes first: on curves it is part of the geometry by now, inside
  /// it may let others go.
  void choose() {
    const std::vector<CurveChain> chains = curve_chains(mesh_);
    roles_ = vertex_roles(mesh_, chains, options_.polygon_tolerance);
    std::vector<PointId> stuck;
    for (const auto& [v, reason] : refused_) {
      if (roles_[at(v)] == VertexRole::curve) roles_[at(v)] = VertexRole::kept;
      if (roles_[at(v)] == VertexRole::inner) stuck.push_back(v);
    }
    std::vector<double> bounds = longest_edges();
    for (double& bound : bounds) bound *= growth;
    if (options_.feature_share > 0) {
      const std::vector<double> features = local_feature_sizes(mesh_, chains);
      for (std::size_t k = 0; k < bounds.size(); ++k)
        bounds[k] = std::min(bounds[k], options_.feature_share * features[k]);
    }
    const std::vector<double> spacing = wanted_spacing(mesh_, chains, roles_, options_.goals, bounds, gradation);
    const std::vector<bool> chosen = independent_set(mesh_, chains, roles_, spacing, stuck, options_.factor);
    slated_.assign(chosen.size(), false);
    for (PointId v = 0; v < mesh_.point_slots(); ++v) slated_[at(v)] = mesh_.is_vertex(v) && !chosen[at(v)];
  }
  /// At each vertex.
  std::vector<double> longest_edges() const {
    std::vector<double> longest(at(mesh_.point_slots()), 0);
    for (HalfEdgeId h = 0; h < 3 * mesh_.triangle_slots(); ++h) {
      if (!mesh_.is_alive(triangle_of(h))) continue;
      const double length = edge_length(h);
      for (const PointId v : {mesh_.origin(h), mesh_.target(h)}) longest[at(v)] = std::max(longest[at(v)], length);
    }
    return longest;
  }
  bool is_slated(PointId v) const { return slated_[at(v)] && mesh_.is_vertex(v); }

  /// One by one; what was refused is tried again when something around it has changed.
  void remove_slated() {
    std::vector<PointId> queue = slated_in_order();
    refused_.clear();
    is_waiting_.assign(slated_.size(), true);
    while (!queue.empty()) {
      waiting_.clear();
      for (const PointId v : queue) {
        is_waiting_[at(v)] = false;
        if (is_slated(v)) remove(v);
      }
      std::swap(queue, waiting_);
    }
    std::erase_if(refused_, [this](const auto& entry) { return !mesh_.is_vertex(entry.first); });
  }

  /// Along Hilbert's curve, which keeps the work in one place of the memory.
  std::vector<PointId> slated_in_order() const {
    const HilbertOrder order(mesh_.box(), 16);
    std::vector<std::pair<std::uint64_t, PointId>> places;
    for (PointId v = 0; v < mesh_.point_slots(); ++v)
      if (slated_[at(v)]) places.emplace_back(order(mesh_.point(v)), v);
    std::sort(places.begin(), places.end());
    std::vector<PointId> slated;
    for (const auto& [place, v] : places) slated.push_back(v);
    return slated;
  }

  /// Removes v, and then others that are slated as long as elements are left that refine would attack.
  void remove(PointId v) {
    Transaction transaction(mesh_);
    chained_.clear();
    around_.clear();
    attacked_.clear();
    worst_before_ = 1;
    double error = 0, integral_change = 0;
    std::string refusal;
    for (PointId w = v; w != none;) {
      const CurveRemoval removal = remove_one(w);
      if (removal.refusal != Refusal::done && w == v) refusal = describe(removal.refusal);
      if (removal.refusal != Refusal::done) break;
      chained_.push_back(w);
      error = std::max(error, removal.error);
      integral_change = std::max(integral_change, removal.integral_change);
      const char* reason = nullptr;
      w = find_culprit(reason);
      refusal = reason ? std::string("would be refined again: ") + reason : "";
      if (chained_.size() == most_chained) break;
    }
    if (refusal.empty() && is_misshapen()) refusal = "would be misshapen";
    if (!refusal.empty()) {
      refused_[v] = refusal;
      return;
    }
    transaction.commit();
    for (const PointId gone : chained_) ++(roles_[at(gone)] == VertexRole::inner ? inner_removals_ : curve_removals_);
    largest_error_ = std::max(largest_error_, error);
    integral_change_ = std::max(integral_change_, integral_change);
    wake_around();
  }

  CurveRemoval remove_one(PointId v) {
    find_star(mesh_, v, star_);
    link_.clear();
    for (const HalfEdgeId h : star_.outgoing) link_.push_back(mesh_.target(h));
    if (!star_.is_closed) link_.push_back(mesh_.apex(star_.outgoing.back()));  // a pinched vertex is not removed
    const bool on_curve = roles_[at(v)] != VertexRole::inner;
    changed_.clear();
    if (on_curve) {
      add_curve_neighbors(v);
      look_around();
    } else {
      for (const HalfEdgeId h : star_.outgoing) changed_.push_back(triangle_of(h));
    }
    for (const TriangleId t : changed_) {
      worst_before_ = std::min(worst_before_, shape_of(t));
      if (chained_.empty() && refine_reason(mesh_, t, options_.goals)) attacked_.push_back(corners_of(t));
    }
    CurveRemoval removal;
    if (on_curve)
      removal = remove_curve_vertex(
          mesh_, v, {options_.tolerance, options_.step_tolerance, options_.keep_area, options_.goals.max_turning},
          options_.refit);
    else
      removal.refusal = remove_inner_vertex(mesh_, v, options_.refit);
    if (removal.refusal != Refusal::done) return removal;
    on_curve ? look_around() : look_inside();
    for (const TriangleId t : changed_)  // flips that the hole's edges now want
      for (int e = 0; e < 3; ++e)
        if (wants_flip(edge_state(mesh_, half_edge(t, e)))) stack_.push_back(half_edge(t, e));
    around_.insert(around_.end(), changed_.begin(), changed_.end());
    legalize(mesh_, stack_, options_.refit, counts_, -1, &around_);
    sort_unique(around_);
    return removal;
  }

  /// The triangles at the link of what is removed.
  void look_around() {
    changed_.clear();
    for (const PointId w : link_) {
      find_star(mesh_, w, star_);
      for (const HalfEdgeId h : star_.outgoing) changed_.push_back(triangle_of(h));
    }
    sort_unique(changed_);
  }

  /// Those of them that lie in the hole, all corners on the link.
  void look_inside() {
    look_around();
    const auto is_outside = [this](PointId v) { return std::find(link_.begin(), link_.end(), v) == link_.end(); };
    std::erase_if(changed_, [&](TriangleId t) {
      return is_outside(mesh_.corner(t, 0)) || is_outside(mesh_.corner(t, 1)) || is_outside(mesh_.corner(t, 2));
    });
  }

  /// Knot removal moves vertices along its curve, too: up to `degree` spans away.
  void add_curve_neighbors(PointId v) {
    chain_.assign(1, v);
    std::size_t first = 0;
    for (int k = 0; k < mesh_.degree(); ++k)
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
    link_.insert(link_.end(), chain_.begin() + 1, chain_.end());
  }

  /// Of an element that refine would attack, and would not have before, a slated vertex whose removal may mend it; or
  /// none. `reason` is why it would be attacked, null if none is.
  PointId find_culprit(const char*& reason) {
    PointId culprit = none;
    for (const TriangleId t : around_) {
      if (!mesh_.is_alive(t)) continue;
      const char* why = refine_reason(mesh_, t, options_.goals);
      if (!why || std::find(attacked_.begin(), attacked_.end(), corners_of(t)) != attacked_.end()) continue;
      reason = why;
      HalfEdgeId shortest = half_edge(t, 0);
      for (int e = 1; e < 3; ++e)
        if (edge_length(half_edge(t, e)) < edge_length(shortest)) shortest = half_edge(t, e);
      culprit = none;
      for (const PointId w : {mesh_.apex(shortest), mesh_.target(shortest), mesh_.origin(shortest)})
        if (is_slated(w)) culprit = w;
      if (culprit == none) return none;
    }
    return culprit;
  }

  bool is_misshapen() const {
    for (const TriangleId t : around_)
      if (mesh_.is_alive(t) && shape_of(t) < std::min(worst_before_, least_shape)) return true;
    return false;
  }

  void wake_around() {
    for (const TriangleId t : around_) {
      if (!mesh_.is_alive(t)) continue;
      for (int c = 0; c < 3; ++c) {
        const PointId w = mesh_.corner(t, c);
        if (!is_slated(w) || is_waiting_[at(w)]) continue;
        is_waiting_[at(w)] = true;
        waiting_.push_back(w);
      }
    }
  }

  double edge_length(HalfEdgeId h) const {
    return distance(mesh_.point(mesh_.origin(h)), mesh_.point(mesh_.target(h)));
  }
  Corners corners_of(TriangleId t) const {
    Corners corners{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
    std::sort(corners.begin(), corners.end());
    return corners;
  }
  double shape_of(TriangleId t) const {
    std::array<Point, net_size(max_degree)> net;
    mesh_.gather_points(t, net);
    return curved_shape(mesh_.degree(), {net.data(), at(mesh_.net_size())});
  }

  PassReport make_report() const {
    PassReport report;
    report.add("removals", static_cast<double>(inner_removals_ + curve_removals_));
    report.add("interior_removals", static_cast<double>(inner_removals_));
    report.add("curve_removals", static_cast<double>(curve_removals_));
    report.add_length("largest_error", largest_error_);
    double accumulated = 0;
    for (const Curve& curve : mesh_.boundary().curves) accumulated = std::max(accumulated, curve.removal_error);
    report.add_length("accumulated_error", accumulated);
    report.add("integral_change", integral_change_);
    report.add("triangles", mesh_.triangle_count());
    for (const auto& [v, reason] : refused_) report.refuse(reason, mesh_.point(v));
    return report;
  }

  Mesh& mesh_;
  const CoarsenOptions& options_;
  std::vector<VertexRole> roles_;
  std::vector<bool> slated_, is_waiting_;
  std::vector<PointId> waiting_;            // what to try once more
  std::map<PointId, std::string> refused_;  // of this round, by vertex
  // One chain of removals:
  std::vector<PointId> chained_, link_, chain_;
  std::vector<TriangleId> around_, changed_;
  std::vector<Corners> attacked_;  // before
  double worst_before_ = 1;
  std::vector<HalfEdgeId> stack_;
  Star star_;
  LegalizeCounts counts_;
  long inner_removals_ = 0, curve_removals_ = 0;
  double largest_error_ = 0, integral_change_ = 0;
};

}  // namespace

PassReport coarsen(Mesh& mesh, const CoarsenOptions& options) { return Coarsener(mesh, options).run(); }

}  // namespace pliant
