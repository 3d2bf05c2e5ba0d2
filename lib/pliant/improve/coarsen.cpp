// lib/pliant/improve/coarsen.cpp: rounds that choose what stays and try to remove the rest, in the light of what refine
// would do.
#include "pliant/improve/coarsen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "pliant/geometry/index.h"
#include "pliant/improve/coarsening/independent_set.h"
#include "pliant/improve/coarsening/local_feature_size.h"
#include "pliant/improve/coarsening/refusal_memory.h"
#include "pliant/improve/coarsening/removal_chain.h"
#include "pliant/improve/refining/left_by_refine.h"
#include "pliant/mesh/hilbert_order.h"

namespace pliant {
namespace {

constexpr double gradation = 0.7;  // Lipschitz constant of the wanted length
constexpr double growth = 1.8;     // a round wants edges at most this many times as long as the longest at a vertex
constexpr int most_coarsening_rounds = 40;  // rounds of choosing what stays and removing the rest
constexpr int most_attempts = 5;  // attempts to find the vertices that must stay so that refine has nothing new to do
constexpr double default_tolerance = 1e-3;  // the default bound of all removals, as a share of the mesh's size
constexpr double default_step_share = 0.1;  // the default bound of one removal, as a share of the bound of all
constexpr double merged_share = 0.5;  // an edge is left by a removal only if it has this share of the resolution error
                                      // at which refine would split it again
constexpr long worthwhile = 1000;     // another round follows one that has removed a vertex for each so many triangles

class Coarsener {
 public:
  /// `options`: resolved; `frozen`: by point slot, true for vertices that are not to be removed.
  Coarsener(Mesh& mesh, const CoarsenOptions& options, const std::vector<bool>& frozen)
      : mesh_(mesh),
        options_(options),
        frozen_(frozen),
        limits_{*options.goals,
                {*options.tolerance, *options.step_tolerance, options.keep_area, options.goals->max_turning,
                 merged_share * options.goals->resolution},
                options.refit,
                accepted_shape(*options.goals),
                options.uses_forecast},
        chain_(mesh, limits_, slated_),
        memories_{RefusalMemory(mesh.point_slots()), RefusalMemory(mesh.point_slots())},
        changed_(index(mesh.point_slots()), 0) {}

  void before_first_removal(std::function<void()> use) { chain_.before_first(std::move(use)); }

  PassReport run() {
    bool is_afresh = true;  // no vertices stuck in an earlier round are preferred: the first round of a new run
    for (int round = 0; round < most_coarsening_rounds; ++round) {
      const long before = removals();
      parity_ = is_afresh ? 0 : 1 - parity_;
      choose();
      remove_slated();
      const long removed = removals() - before;
      if (removed > 0) {
        is_afresh = false;
        if (removed * worthwhile < mesh_.triangle_count()) break;
      } else {
        if (is_afresh) break;
        is_afresh = true;
        stuck_.clear();
      }
    }
    PassReport report = make_report();
    mesh_.compact();
    return report;
  }

  /// The removed vertices, by the numbers that the mesh had at first.
  const std::vector<PointId>& removed() const { return removed_; }

 private:
  /// Chooses the vertices that stay and slates the others. Those that could not be removed in the last round come
  /// first: on curves they now count as needed by the geometry; inside, choosing them may let others be removed.
  void choose() {
    const std::vector<CurveChain> chains = curve_chains(mesh_);
    roles_ = vertex_roles(mesh_, chains, options_.polygon_tolerance);
    for (PointId v = 0; v < mesh_.point_slots(); ++v)
      if (frozen_[index(v)]) roles_[index(v)] = VertexRole::kept;
    std::vector<PointId> stuck;
    for (const PointId v : stuck_) {
      if (!mesh_.is_vertex(v)) continue;
      if (roles_[index(v)] == VertexRole::curve) roles_[index(v)] = VertexRole::kept;
      if (roles_[index(v)] == VertexRole::inner) stuck.push_back(v);
    }
    const VertexGraph graph(mesh_);
    std::vector<double> bounds = longest_edges(graph);
    for (double& bound : bounds) bound *= growth;
    if (options_.feature_share > 0) {
      const std::vector<double> features = local_feature_sizes(mesh_, chains);
      for (std::size_t k = 0; k < bounds.size(); ++k)
        bounds[k] = std::min(bounds[k], options_.feature_share * features[index(graph.vertex(static_cast<int>(k)))]);
    }
    const std::vector<double> spacing =
        wanted_spacing(mesh_, graph, chains, roles_, limits_.goals, std::move(bounds), gradation);
    const std::vector<bool> chosen = independent_set(mesh_, graph, chains, roles_, spacing, stuck, options_.factor);
    slated_.assign(chosen.size(), false);
    for (PointId v = 0; v < mesh_.point_slots(); ++v) slated_[index(v)] = mesh_.is_vertex(v) && !chosen[index(v)];
  }
  /// The longest edge at each vertex, by number in the graph.
  static std::vector<double> longest_edges(const VertexGraph& graph) {
    std::vector<double> longest;
    longest.reserve(index(graph.count()));
    for (int k = 0; k < graph.count(); ++k) {
      const Point place = graph.place(k);
      double squared = 0;
      for (const int near : graph.around(k)) squared = std::max(squared, squared_length(graph.place(near) - place));
      double here = std::sqrt(squared);
      if (!(squared > 1e-280 && squared < 1e280)) {  // where squares under- or overflow
        here = 0;
        for (const int near : graph.around(k)) here = std::max(here, quick_distance(graph.place(near), place));
      }
      longest.push_back(here);
    }
    return longest;
  }
  bool is_slated(PointId v) const { return slated_[index(v)] && mesh_.is_vertex(v); }

  /// Removes slated vertices one by one. A vertex whose removal was refused is tried again when something around it has
  /// changed.
  void remove_slated() {
    std::vector<PointId> queue = slated_in_order();
    refused_.clear();
    is_waiting_.assign(slated_.size(), true);
    while (!queue.empty()) {
      waiting_.clear();
      for (const PointId v : queue) {
        is_waiting_[index(v)] = false;
        if (is_slated(v)) remove(v);
      }
      std::swap(queue, waiting_);
    }
    std::erase_if(refused_, [this](PointId v) { return !mesh_.is_vertex(v); });
    std::sort(refused_.begin(), refused_.end());
    refused_.erase(std::unique(refused_.begin(), refused_.end()), refused_.end());
    stuck_ = refused_;
  }
  long removals() const { return static_cast<long>(removed_.size()); }

  /// The slated vertices along Hilbert's curve, so that one follows another that is near it in memory.
  std::vector<PointId> slated_in_order() const {
    const HilbertOrder order(mesh_.box(), 16);
    std::vector<std::uint64_t> places;  // on the curve, 32 bits, then the vertex
    for (PointId v = 0; v < mesh_.point_slots(); ++v)
      if (slated_[index(v)]) places.push_back((order(mesh_.point(v)) << 32) | index(v));
    std::sort(places.begin(), places.end());
    std::vector<PointId> slated;
    slated.reserve(places.size());
    for (const std::uint64_t place : places) slated.push_back(static_cast<PointId>(place & 0xffffffffu));
    return slated;
  }

  void remove(PointId v) {
    if (memories_[index(parity_)].is_refused(v, changed_, slated_)) {
      refused_.push_back(v);
      return;
    }
    const RemovalRefusal refusal = chain_.remove(v, roles_[index(v)] != VertexRole::inner);
    if (refusal.reason != nullptr) {
      memories_[index(parity_)].note(v, refusal, clock_, chain_.decided_by(), slated_);
      refused_.push_back(v);
      return;
    }
    ++clock_;
    for (const PointId gone : chain_.removed())
      ++(roles_[index(gone)] == VertexRole::inner ? inner_removals_ : curve_removals_);
    removed_.insert(removed_.end(), chain_.removed().begin(), chain_.removed().end());
    largest_error_ = std::max(largest_error_, chain_.error());
    integral_change_ = std::max(integral_change_, chain_.integral_change());
    note_changes();
  }

  /// Notes what the last removal has changed, and queues the slated vertices there once more.
  void note_changes() {
    for (const PointId w : chain_.along_curves()) changed_[index(w)] = clock_;
    for (const TriangleId t : chain_.around()) {
      if (!mesh_.is_alive(t)) continue;
      for (int c = 0; c < 3; ++c) {
        const PointId w = mesh_.corner(t, c);
        changed_[index(w)] = clock_;
        if (!is_slated(w) || is_waiting_[index(w)]) continue;
        is_waiting_[index(w)] = true;
        waiting_.push_back(w);
      }
    }
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
    for (const PointId v : refused_) {
      const RemovalRefusal& refusal = memories_[index(parity_)].refusal(v);
      report.refuse((refusal.is_refinement ? "would be refined again: " : "") + std::string(refusal.reason),
                    mesh_.point(v));
    }
    return report;
  }

  Mesh& mesh_;
  const CoarsenOptions& options_;
  const std::vector<bool>& frozen_;
  std::vector<VertexRole> roles_;
  std::vector<bool> slated_, is_waiting_;
  std::vector<PointId> waiting_;  // slated vertices to be tried once more
  std::vector<PointId> removed_;
  std::vector<PointId> refused_;  // slated vertices that could not be removed in this round
  std::vector<PointId> stuck_;    // the same of the last round
  RemovalChain::Limits limits_;
  RemovalChain chain_;
  // By vertex:
  // One for even rounds and one for odd ones: every other round slates much the same vertices.
  std::array<RefusalMemory, 2> memories_;
  int parity_ = 0;
  std::vector<long> changed_;  // the time (clock_) of the last change of its star
  long clock_ = 0;             // counts removals
  long inner_removals_ = 0, curve_removals_ = 0;
  double largest_error_ = 0, integral_change_ = 0;
};

/// Freezes the removed vertices near places where refine would now succeed: their removal may have let it. Every
/// attempt looks in a circle twice as wide. False if there are none, or after too many attempts.
bool freeze(const Mesh& mesh, const std::vector<PointId>& removed, const std::vector<LeftByRefine::Awakened>& awakened,
            int attempt, std::vector<bool>& frozen) {
  if (attempt == most_attempts) return false;
  bool any = false;
  for (const PointId v : removed)
    if (std::any_of(awakened.begin(), awakened.end(), [&](const LeftByRefine::Awakened& each) {
          return distance(each.place, mesh.point(v)) <= std::ldexp(each.reach, attempt);
        }))
      frozen[index(v)] = any = true;
  return any;
}

/// The options with what their absence means for this mesh.
CoarsenOptions resolve(CoarsenOptions options, const Mesh& mesh) {
  if (!options.goals) options.goals = goals_of(mesh);
  const double resolution = options.goals->resolution;
  const bool is_bounded = options.tolerance.has_value();
  if (!is_bounded) options.tolerance = resolution < HUGE_VAL ? HUGE_VAL : default_tolerance * mesh.size();
  if (!options.step_tolerance) options.step_tolerance = std::min(default_step_share * *options.tolerance, resolution);
  return options;
}

}  // namespace

PassReport coarsen(Mesh& mesh, const CoarsenOptions& asked) {
  const CoarsenOptions options = resolve(asked, mesh);
  LeftByRefine left(mesh, *options.goals);
  std::vector<bool> frozen(index(mesh.point_slots()), false);
  for (int attempt = 0;; ++attempt) {
    Coarsener coarsener(mesh, options, frozen);
    if (left.any() && attempt == 0) coarsener.before_first_removal([&] { left.keep(mesh); });
    PassReport report = coarsener.run();
    if (!left.any() || coarsener.removed().empty()) return report;
    const std::vector<LeftByRefine::Awakened> awakened = left.awakened_in(mesh);
    if (awakened.empty()) return report;
    mesh = left.before();
    if (!freeze(mesh, coarsener.removed(), awakened, attempt, frozen)) frozen.assign(frozen.size(), true);
  }
}

}  // namespace pliant
