#include "pliant/improve/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/predicates.h"
#include "pliant/geometry/protective_lens.h"
#include "pliant/improve/feature_sizes.h"
#include "pliant/improve/legalize.h"
#include "pliant/improve/refine_attack.h"
#include "pliant/improve/sharp_corners.h"
#include "pliant/improve/split_place.h"
#include "pliant/mesh/locate.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/insert_point.h"

namespace pliant {
namespace {

constexpr int failure = 20;             // counts as many splits that did not help
constexpr int max_failures = 40;        // of one triangle
constexpr double default_floor = 1e-9;  // of the mesh's size: least distance of two vertices
constexpr double least_of_root = 0.25;  // no edge shorter than this part of the feature that it comes from
constexpr double least_of_longest = 0.2;
constexpr long most_old = 8;         // triangles to a new vertex in a mesh that keeps its numbers
constexpr double near_edge = 1e-3;   // of the distance to the nearest corner
constexpr double off_center = 0.95;  // of the distance at which the triangle would be just good enough

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Refiner {
 public:
  Refiner(Mesh& mesh, const RefineOptions& options)
      : mesh_(mesh), options_(options), locator_(mesh), corners_(mesh), roots_(mesh) {
    floor_ = std::max(options.goals.min_size, default_floor * mesh.size());
    most_ratio_ = 1 / (2 * std::sin(options.goals.min_angle * std::numbers::pi / 180));
  }

  PassReport run() {
    for (TriangleId t = 0; t < mesh_.triangle_slots(); ++t) enqueue(t);
    while (insertions_ + splits_ < options_.max_insertions) {
      std::optional<AttackEntry> entry = queue_.pop();
      if (!entry) {
        if (failed_.empty()) break;
        for (const TriangleId t : std::exchange(failed_, {})) enqueue(t);  // once more, now that all else is done
        continue;
      }
      const auto& [t, corners] = *entry;
      if (!mesh_.is_alive(t) || corners_of(t) != corners) continue;
      const Attack attack = attack_on(mesh_, t, options_.goals);
      if (attack.reason) treat(t, attack);
      if (options_.progress != nullptr) options_.progress->count(insertions_ + splits_);
    }
    // Numbers in the order of insertion would send every later pass from one end of the memory to the other.
    if ((insertions_ + splits_) * most_old > mesh_.triangle_count())
      mesh_.renumber();
    else
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
    least_edge_ = root_ = 0;
    if (attack.edge != none) {
      if (!split(attack.edge)) give_up("too curved: no room to split");
      return;
    }
    if (attack.is_poor)
      if (const HalfEdgeId curve = curve_that_turns_over(mesh_, t); curve != none && split(curve)) return enqueue(t);
    const HalfEdgeId shortest = shortest_edge(t);
    const PointId p = mesh_.origin(shortest), q = mesh_.target(shortest);
    if (distance(mesh_.point(p), mesh_.point(q)) <= 2 * floor_) return give_up("at the least size");
    const double longest =
        std::sqrt(std::max({squared(shortest), squared(next(shortest)), squared(previous(shortest))}));
    if (attack.is_poor && !corners_.empty() && corners_.is_along_shell(mesh_, shortest, longest))
      return give_up("opposite a small angle");
    const auto corners = corners_of(t);
    const auto failures = failures_.find(corners);
    if (failures != failures_.end() && failures->second >= max_failures) {
      if (!attack.is_poor && split_longest(t)) return;  // what is too large can always be divided
      return give_up("circumcentre refused");
    }
    // The circumcentre of a large triangle is at least half its longest edge away from all, if the mesh is Delaunay.
    least_edge_ = least_of_longest * longest;
    // Mending a shape must not make edges much shorter than the features that the triangle's corners come from: with
    // the bounds on angles that can be kept this is what holds anyway (Ruppert); where curved edges or small angles
    // spoil that, it is what ends the refinement.
    if (attack.is_poor) {
      root_ = std::min(roots_.of(p), roots_.of(q));
      least_edge_ = least_of_root * root_;
    }
    if (!insert_into(t, shortest, attack.is_poor)) {
      failures_[corners] += failure;
      failed_.push_back(t);
    } else if (mesh_.is_alive(t) && corners_of(t) == corners) {
      if (attack.is_poor) ++failures_[corners];
      enqueue(t);
    }
  }

  /// Inserts the off-centre of a poor triangle, which makes its shortest edge's new triangle just good enough (Üngör),
  /// or where that is refused the circumcentre, as into all others.
  bool insert_into(TriangleId t, HalfEdgeId shortest, bool is_poor) {
    const Point &a = mesh_.point(mesh_.origin(shortest)), &b = mesh_.point(mesh_.target(shortest)),
                &c = mesh_.point(mesh_.apex(shortest));
    const Point center = circumcenter(a, b, c);
    if (!is_finite(center)) return split_longest(t);
    if (is_poor) {
      const Point middle = (a + b) / 2;
      const double height = off_center * (most_ratio_ + std::sqrt(most_ratio_ * most_ratio_ - 0.25)) * distance(a, b);
      const Vector up = center - middle;
      const double far = length(up);
      if (far > height && insert_or_split(t, middle + (height / far) * up)) return true;
    }
    return insert_or_split(t, center);
  }

  /// Inserts p, or splits the constrained edge that stands between t and p or whose lens p enters.
  bool insert_or_split(TriangleId t, const Point& p) {
    const HalfEdgeId wall = walk_to(t, p);
    // An empty circumcircle whose centre lies beyond a wall bounds how short that is; where flips were refused it may
    // not be empty.
    if (wall != none) return 2 * std::sqrt(squared(wall)) >= distance_from(wall, t) && split(wall);
    const HalfEdgeId encroached = find_encroached(reached_, p);
    if (encroached != none) return split(encroached);
    const auto location = locator_.walk(p, reached_);
    if (!location) return false;
    const TriangleId k = location->triangle;
    double nearest = HUGE_VAL;
    for (int c = 0; c < 3; ++c) nearest = std::min(nearest, distance(mesh_.point(mesh_.corner(k, c)), p));
    if (nearest < std::max(floor_, least_edge_)) return false;
    const FaceId wanted = mesh_.face(t);
    if (mesh_.face(k) != wanted) return false;
    const InsertResult inserted = insert_point(mesh_, k, location->xi, edge_tolerance(k, location->xi, nearest));
    if (inserted.refusal != Refusal::done) {
      ++refusals_[describe(inserted.refusal)];
      return false;
    }
    ++insertions_;
    settle(inserted.vertex);
    return true;
  }

  /// Near an edge of the element, compared with the nearest corner, the edge itself is split: slivers would not flip
  /// away at a curve.
  double edge_tolerance(TriangleId k, const Barycentric& xi, double nearest) const {
    const auto c = static_cast<int>(std::min_element(xi.begin(), xi.end()) - xi.begin());
    const double least = std::max(0.0, xi[at(c)]);
    const Point &a = mesh_.point(mesh_.corner(k, c)), &b = mesh_.point(mesh_.corner(k, (c + 1) % 3)),
                &d = mesh_.point(mesh_.corner(k, (c + 2) % 3));
    const double height = std::fabs(cross(b - a, d - a)) / distance(b, d);
    return least * height < near_edge * nearest ? std::nextafter(least, 1.0) : std::min(least, near_edge);
  }

  /// From the chord of an edge to the nearest corner of a triangle.
  double distance_from(HalfEdgeId h, TriangleId t) const {
    const Point& a = mesh_.point(mesh_.origin(h));
    const Vector along = mesh_.point(mesh_.target(h)) - a;
    double least = HUGE_VAL;
    for (int c = 0; c < 3; ++c) {
      const Vector off = mesh_.point(mesh_.corner(t, c)) - a;
      const double s = std::clamp(dot(off, along) / squared_length(along), 0.0, 1.0);
      least = std::min(least, squared_length(off - s * along));
    }
    return std::sqrt(least);
  }

  double squared(HalfEdgeId h) const {
    return squared_length(mesh_.point(mesh_.target(h)) - mesh_.point(mesh_.origin(h)));
  }
  HalfEdgeId shortest_edge(TriangleId t) const {
    HalfEdgeId shortest = half_edge(t, 0);
    for (int e = 1; e < 3; ++e)
      if (squared(half_edge(t, e)) < squared(shortest)) shortest = half_edge(t, e);
    return shortest;
  }
  bool split_longest(TriangleId t) {
    HalfEdgeId longest = half_edge(t, 0);
    for (int e = 1; e < 3; ++e)
      if (squared(half_edge(t, e)) > squared(longest)) longest = half_edge(t, e);
    return split(longest);
  }

  bool split(HalfEdgeId h) {
    const double half = std::sqrt(squared(h)) / 2;
    if (half <= floor_ || half < least_edge_) return false;
    const bool on_curve = mesh_.is_constrained(h);
    const InsertResult result = split_edge(mesh_, h, on_curve ? split_place(mesh_, h, corners_) : 0.5);
    if (result.refusal != Refusal::done) {
      ++refusals_[describe(result.refusal)];
      return false;
    }
    ++(on_curve ? splits_ : insertions_);
    settle(result.vertex);
    return true;
  }

  /// Subdivision bends the edges to a new vertex where an element's parameters run unevenly along a curve. The
  /// triangles that they bound would be far from their logical ones, on which all decisions rest.
  void straighten_spokes() {
    bent_ = star_.outgoing;
    straighten_bent(mesh_, bent_, options_.refit);
  }

  /// Restores the Delaunay property around a new vertex, then queues what changed.
  void settle(PointId v) {
    find_star(mesh_, v, star_);
    touched_.clear();
    for (const HalfEdgeId h : star_.outgoing) {
      stack_.push_back(next(h));
      touched_.push_back(triangle_of(h));
    }
    straighten_spokes();
    legalize(mesh_, stack_, options_.refit, counts_, -1, &touched_, true);
    find_star(mesh_, v, star_);
    roots_.set(mesh_, star_, root_, corners_);
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
  SharpCorners corners_;
  double floor_ = 0, most_ratio_ = 0;
  double root_ = 0, least_edge_ = 0;  // no new edge may be shorter, while a poor triangle is treated
  FeatureSizes roots_;
  AttackQueue queue_;
  std::map<std::array<PointId, 3>, int> failures_;
  std::vector<TriangleId> failed_;  // to be tried once more
  std::map<std::string, long> given_up_, refusals_;
  LegalizeCounts counts_;
  long insertions_ = 0, splits_ = 0;
  Star star_;
  std::vector<HalfEdgeId> stack_, bent_;
  std::vector<TriangleId> touched_, cavity_;
  TriangleId reached_ = none;
};

}  // namespace

PassReport refine(Mesh& mesh, const RefineOptions& options) { return Refiner(mesh, options).run(); }

const char* refine_reason(const Mesh& mesh, TriangleId t, const QualityGoals& goals) {
  return attack_on(mesh, t, goals).reason;
}

}  // namespace pliant
