#include "pliant/improve/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

#include "pliant/geometry/jacobian.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/predicates.h"
#include "pliant/geometry/protective_lens.h"
#include "pliant/geometry/turning_angle.h"
#include "pliant/improve/legalize.h"
#include "pliant/mesh/locate.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/insert_point.h"

namespace pliant {
namespace {

constexpr int max_failures = 2;         // of one triangle's circumcentre
constexpr double default_floor = 1e-9;  // of the mesh's size: least distance of two vertices
constexpr double rounding_slack = 0.999;
constexpr double size_slack = 1.5;  // a longest edge of this many wanted lengths is too long

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Attack {
  const char* reason = nullptr;
  double excess = 0;       // how far beyond its bound: worst first
  HalfEdgeId edge = none;  // too curved: the edge to split
  bool is_poor = false;
};

double edge_turning(const Mesh& mesh, HalfEdgeId h) {
  std::array<Point, max_degree + 1> polygon;
  mesh.gather_edge_points(h, polygon);
  return turning_angle({polygon.data(), at(mesh.degree() + 1)});
}

Attack attack_on(const Mesh& mesh, TriangleId t, const QualityGoals& goals) {
  const Point &a = mesh.point(mesh.corner(t, 0)), &b = mesh.point(mesh.corner(t, 1)),
              &c = mesh.point(mesh.corner(t, 2));
  Attack attack;
  if (goals.max_turning < HUGE_VAL && mesh.degree() > 1)
    for (int e = 0; e < 3; ++e) {
      // Only what lies on a curve: inner edges are for smoothing.
      const HalfEdgeId h = half_edge(t, e);
      if (!mesh.is_constrained(h)) continue;
      const double ratio = edge_turning(mesh, h) / goals.max_turning;
      if (ratio > 1 && ratio > attack.excess) attack = {"too curved", ratio, h, false};
    }
  if (attack.reason) return attack;
  const double bound = goals.area_bound(mesh.face(t));
  if (bound < HUGE_VAL) {
    std::array<Point, net_size(max_degree)> net;
    mesh.gather_points(t, net);
    const double ratio = element_area(mesh.degree(), {net.data(), at(mesh.net_size())}) / bound;
    if (ratio > 1) return {"too large", ratio, none, false};
  }
  if (goals.size) {
    const double wanted = goals.size((1.0 / 3) * (a + b + c), mesh.time);
    const double longest = std::sqrt(std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)}));
    if (wanted > 0 && longest > size_slack * wanted) return {"too large", longest / (size_slack * wanted), none, false};
  }
  if (goals.min_angle > 0) {
    const double limit = 1 / (2 * std::sin(goals.min_angle * std::numbers::pi / 180));
    const double ratio = radius_edge_ratio(a, b, c);
    if (ratio > limit) return {"too poor", ratio / limit, none, true};
  }
  return {};
}

struct Entry {
  TriangleId triangle;
  std::array<PointId, 3> corners;  // as queued: the slot may have become another triangle
};

/// Worst first, to a sixteenth of a power of two; of those the one queued last, which keeps the work in one place.
class AttackQueue {
 public:
  void push(double excess, const Entry& entry) {
    const double place = 16 * std::log2(excess);
    const auto bucket = static_cast<std::size_t>(std::clamp(place, 0.0, double(buckets_.size() - 1)));
    buckets_[bucket].push_back(entry);
    top_ = std::max(top_, bucket);
  }
  std::optional<Entry> pop() {
    while (buckets_[top_].empty()) {
      if (top_ == 0) return std::nullopt;
      --top_;
    }
    const Entry entry = buckets_[top_].back();
    buckets_[top_].pop_back();
    return entry;
  }

 private:
  std::array<std::vector<Entry>, 1024> buckets_;
  std::size_t top_ = 0;
};

class Refiner {
 public:
  Refiner(Mesh& mesh, const RefineOptions& options) : mesh_(mesh), options_(options), locator_(mesh) {
    floor_ = std::max(options.goals.min_size, default_floor * mesh.size());
  }

  PassReport run() {
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) enqueue(t);
    while (insertions_ + splits_ < options_.max_insertions) {
      const std::optional<Entry> entry = queue_.pop();
      if (!entry) break;
      const auto& [t, corners] = *entry;
      if (!mesh_.is_alive(t) || corners_of(t) != corners) continue;
      const Attack attack = attack_on(mesh_, t, options_.goals);
      if (attack.reason) treat(t, attack);
    }
    mesh_.compact();
    return report();
  }

 private:
  std::array<PointId, 3> corners_of(TriangleId t) const {
    return {mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
  }
  void enqueue(TriangleId t) {
    if (!mesh_.is_alive(t)) return;
    const Attack attack = attack_on(mesh_, t, options_.goals);
    if (attack.reason) queue_.push(attack.excess, {t, corners_of(t)});
  }

  void treat(TriangleId t, const Attack& attack) {
    if (attack.edge != none) {
      least_edge_ = 0;
      if (!split(attack.edge, 0.5)) give_up("too curved: no room to split");
      return;
    }
    const Point a = mesh_.point(mesh_.corner(t, 0)), b = mesh_.point(mesh_.corner(t, 1)),
                c = mesh_.point(mesh_.corner(t, 2));
    const double shortest = std::sqrt(std::min({squared_length(b - a), squared_length(c - b), squared_length(a - c)}));
    if (shortest <= 2 * floor_) return give_up("at the least size");
    const auto corners = corners_of(t);
    const auto failures = failures_.find(corners);
    if (failures != failures_.end() && failures->second >= max_failures) {
      least_edge_ = 0;
      if (!attack.is_poor && split_longest(t)) return;  // what is too large can always be divided
      return give_up("circumcentre refused");
    }
    // Mending a shape must not make edges shorter than the triangle's own shortest: with the bounds on angles that can
    // be kept this is what holds anyway (Ruppert); where curved edges spoil that, it is what ends the refinement.
    least_edge_ = attack.is_poor ? shortest : 0;
    if (!insert_circumcenter(t, circumcenter(a, b, c))) {
      ++failures_[corners];
      enqueue(t);  // once more, after whatever the failure has changed; then it is given up
    } else if (mesh_.is_alive(t) && corners_of(t) == corners) {
      enqueue(t);
    }
  }

  /// Inserts p, or splits the constrained edge that stands between t and p or whose lens p enters.
  bool insert_circumcenter(TriangleId t, const Point& p) {
    if (!is_finite(p)) return split_longest(t);
    const HalfEdgeId wall = walk_to(t, p);
    if (wall != none) return split(wall, 0.5);
    const HalfEdgeId encroached = find_encroached(reached_, p);
    if (encroached != none) return split(encroached, 0.5);
    const auto location = locator_.walk(p, reached_);
    if (!location) return false;
    const TriangleId k = location->triangle;
    for (int c = 0; c < 3; ++c)
      if (distance(mesh_.point(mesh_.corner(k, c)), p) < std::max(floor_, least_edge_ * rounding_slack)) return false;
    const FaceId wanted = mesh_.face(t);
    if (mesh_.face(k) != wanted) return false;
    // Near an edge of the element the edge itself is split: slivers would not flip away at a curve.
    const InsertResult inserted = insert_point(mesh_, k, location->xi, 1e-3);
    if (inserted.refusal != Refusal::done) {
      ++refusals_[describe(inserted.refusal)];
      return false;
    }
    ++insertions_;
    settle(inserted.vertex);
    return true;
  }

  bool split_longest(TriangleId t) {
    HalfEdgeId longest = half_edge(t, 0);
    const auto squared = [&](HalfEdgeId h) {
      return squared_length(mesh_.point(mesh_.target(h)) - mesh_.point(mesh_.origin(h)));
    };
    for (int e = 1; e < 3; ++e)
      if (squared(half_edge(t, e)) > squared(longest)) longest = half_edge(t, e);
    return split(longest, 0.5);
  }

  bool split(HalfEdgeId h, double s) {
    const double half = distance(mesh_.point(mesh_.origin(h)), mesh_.point(mesh_.target(h))) / 2;
    if (half <= floor_ || half < least_edge_ * rounding_slack) return false;
    const bool on_curve = mesh_.is_constrained(h);
    const InsertResult result = split_edge(mesh_, h, s);
    if (result.refusal != Refusal::done) {
      ++refusals_[describe(result.refusal)];
      return false;
    }
    ++(on_curve ? splits_ : insertions_);
    settle(result.vertex);
    return true;
  }

  /// Restores the Delaunay property around a new vertex, then queues what changed.
  void settle(PointId v) {
    find_star(mesh_, v, star_);
    touched_.clear();
    for (const HalfEdgeId h : star_.outgoing) {
      stack_.push_back(next(h));
      touched_.push_back(triangle_of(h));
    }
    legalize(mesh_, stack_, options_.refit, counts_, -1, &touched_);
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const TriangleId t : touched_) enqueue(t);
  }

  /// Walks in the logical mesh from t's centroid to p; a constrained edge that stands in the way, or none. `reached_`
  /// is the last triangle.
  HalfEdgeId walk_to(TriangleId t, const Point& p) {
    const Point start = (1.0 / 3) * (mesh_.point(mesh_.corner(t, 0)) + mesh_.point(mesh_.corner(t, 1)) +
                                     mesh_.point(mesh_.corner(t, 2)));
    reached_ = t;
    HalfEdgeId entered = none;
    for (long step = 0; step < 10 + 2L * mesh_.triangle_count(); ++step) {
      HalfEdgeId leave = none;
      for (int e = 0; e < 3; ++e) {
        const HalfEdgeId h = half_edge(reached_, e);
        const Point &a = mesh_.point(mesh_.origin(h)), &b = mesh_.point(mesh_.target(h));
        if (h == entered || orient2d(a, b, p) >= 0) continue;
        if (orient2d(start, p, a) <= 0 && orient2d(start, p, b) >= 0) leave = h;  // the segment leaves through it
        if (leave == none) leave = h;
      }
      if (leave == none) return none;
      if (mesh_.is_constrained(leave) || mesh_.twin(leave) == none) return leave;
      entered = mesh_.twin(leave);
      reached_ = triangle_of(entered);
    }
    return none;
  }

  /// A constrained edge at the border of p's Delaunay cavity in whose lens p lies; the nearest one.
  HalfEdgeId find_encroached(TriangleId from, const Point& p) {
    cavity_.assign(1, from);
    HalfEdgeId found = none;
    double nearest = HUGE_VAL;
    for (std::size_t k = 0; k < cavity_.size() && k < 200; ++k)
      for (int e = 0; e < 3; ++e) {
        const HalfEdgeId h = half_edge(cavity_[k], e), g = mesh_.twin(h);
        if (mesh_.is_constrained(h) || g == none) {
          std::array<Point, max_degree + 1> polygon;
          mesh_.gather_edge_points(h, polygon);
          if (!is_encroached({polygon.data(), at(mesh_.degree() + 1)}, p)) continue;
          const double far = distance(0.5 * (polygon[0] + polygon[at(mesh_.degree())]), p);
          if (far < nearest) nearest = far, found = h;
          continue;
        }
        const TriangleId other = triangle_of(g);
        if (std::find(cavity_.begin(), cavity_.end(), other) != cavity_.end()) continue;
        if (in_circle(mesh_.point(mesh_.corner(other, 0)), mesh_.point(mesh_.corner(other, 1)),
                      mesh_.point(mesh_.corner(other, 2)), p) > 0)
          cavity_.push_back(other);
      }
    return found;
  }

  void give_up(const char* reason) { ++given_up_[reason]; }

  PassReport report() const {
    PassReport report;
    report.add("insertions", static_cast<double>(insertions_ + splits_));
    report.add("interior_insertions", static_cast<double>(insertions_));
    report.add("curve_splits", static_cast<double>(splits_));
    report.add("flips", static_cast<double>(counts_.flips));
    long left = 0;
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t)
      if (attack_on(mesh_, t, options_.goals).reason) ++left;
    report.add("left", static_cast<double>(left));
    report.add("triangles", mesh_.triangle_count());
    for (const auto& [reason, times] : given_up_) report.refuse(reason, times);
    for (const auto& [reason, times] : refusals_) report.refuse("insertion: " + reason, times);
    for (const auto& [reason, times] : counts_.refusals) report.refuse(std::string("flip: ") + describe(reason), times);
    return report;
  }

  Mesh& mesh_;
  const RefineOptions& options_;
  Locator locator_;
  double floor_ = 0;
  double least_edge_ = 0;  // no new edge may be shorter, while a poor triangle is treated
  AttackQueue queue_;
  std::map<std::array<PointId, 3>, int> failures_;
  std::map<std::string, long> given_up_, refusals_;
  LegalizeCounts counts_;
  long insertions_ = 0, splits_ = 0;
  Star star_;
  std::vector<HalfEdgeId> stack_;
  std::vector<TriangleId> touched_, cavity_;
  TriangleId reached_ = none;
};

}  // namespace

PassReport refine(Mesh& mesh, const RefineOptions& options) { return Refiner(mesh, options).run(); }

const char* refine_reason(const Mesh& mesh, TriangleId t, const QualityGoals& goals) {
  return attack_on(mesh, t, goals).reason;
}

}  // namespace pliant
