// lib/pliant/improve/refine.cpp: rounds in which each bad triangle has an edge split, gets a point, or is given up.
#include "pliant/improve/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "pliant/boundary/boundary_spans.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/improve/legalize.h"
#include "pliant/improve/refining/expected_insertions.h"
#include "pliant/improve/refining/find_poor.h"
#include "pliant/improve/refining/insertion_search.h"
#include "pliant/improve/refining/refine_attack.h"
#include "pliant/improve/refining/sharp_corners.h"
#include "pliant/improve/refining/tame.h"
#include "pliant/improve/smoothing/split_place.h"
#include "pliant/improve/triangle_budget.h"
#include "pliant/mesh/locate.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/insert_point.h"

namespace pliant {
namespace {

// A poor triangle is given up after so many points were inserted for its sake.
constexpr int most_points = 40;
// The least distance of two vertices, where the goals name none, is this share of the mesh's size.
constexpr double default_floor = 1e-9;
// A new vertex keeps this share of the longest edge of a triangle that is too large as its distance from all others.
constexpr double least_of_longest = 0.2;
// Half of an edge that is split for a poor triangle is at least this share of the triangle's shortest edge. Only bounds
// on angles up to 30 degrees allow less than the whole of it.
constexpr double least_of_shortest = 0.8;
// An edge on a curve may have shorter halves than that if they are at least this share of the distance from its chord
// to the nearer vertex opposite.
constexpr double least_of_gap = 0.5;
// The off-centre of a poor triangle lies at this share of the distance at which the new triangle on its shortest edge
// would be just good enough.
constexpr double off_center = 0.95;
// A mesh is renumbered after a round that leaves fewer triangles than this for each new vertex.
constexpr long triangles_per_new_vertex = 8;

/// What all rounds have done, and which triangles the last one has given up.
struct Tally {
  long insertions = 0, splits = 0;
  LegalizeCounts flips;
  std::map<std::array<PointId, 3>, const char*> left;  ///< the reason, by the triangle's corners

  long points() const { return insertions + splits; }
};

/// One round: attacks every triangle that misses the goals, and those that its changes make miss them. It remembers
/// nothing of earlier rounds.
class Round {
 public:
  Round(Mesh& mesh, const RefineOptions& options, Tally& tally)
      : mesh_(mesh), options_(options), tally_(tally), locator_(mesh), corners_(mesh), search_(mesh) {
    floor_ = std::max({options.goals->min_size, default_floor * mesh.size(), 4 * mesh.tolerance()});
    most_ratio_ = 1 / (2 * std::sin(options.goals->min_angle * std::numbers::pi / 180));
  }

  /// `bad`: what find_bad finds.
  void run(const std::vector<TriangleId>& bad) {
    for (const TriangleId t : bad) enqueue(t);
    while (!options_.max_insertions || tally_.points() < *options_.max_insertions) {
      const std::optional<AttackEntry> entry = queue_.pop();
      if (!entry) return;
      const auto& [t, corners] = *entry;
      if (!mesh_.is_alive(t) || corners_of(mesh_, t) != corners) continue;
      const Attack attack = attack_on(mesh_, t, *options_.goals);
      if (attack.reason) treat(t, attack);
      if (options_.progress != nullptr) options_.progress->count(tally_.points());
      const bool has_inserted = !star_.outgoing.empty();  // before that, the mesh as given may have more
      if (has_inserted && mesh_.triangle_count() > options_.max_triangles) exceed(attack);
    }
  }

  static std::array<PointId, 3> corners_of(const Mesh& mesh, TriangleId t) {
    return {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
  }

 private:
  void enqueue(TriangleId t) {
    if (!mesh_.is_alive(t)) return;
    const Attack attack = attack_on(mesh_, t, *options_.goals);
    if (attack.reason) queue_.push(attack.excess, {t, corners_of(mesh_, t)});
  }
  void give_up(TriangleId t, const char* reason) { tally_.left[corners_of(mesh_, t)] = reason; }
  [[noreturn]] void exceed(const Attack& attack) const;

  void treat(TriangleId t, const Attack& attack) {
    least_edge_ = least_half_ = 0;
    why_not_ = nullptr;
    if (attack.edge != none) {
      if (!split(attack.edge)) give_up(t, why_not_);
      return;
    }
    if (attack.is_poor)
      if (const HalfEdgeId curve = curve_that_turns_over(mesh_, t); curve != none && split(curve)) return enqueue(t);
    const HalfEdgeId shortest = shortest_edge(mesh_, t);
    const double least = std::sqrt(squared(shortest));
    if (least <= 2 * floor_) return give_up(t, "at the least size");
    const double longest = longest_edge(mesh_, t);
    if (attack.is_poor && is_excused(mesh_, t, corners_)) return give_up(t, "opposite a small angle");
    const auto corners = corners_of(mesh_, t);
    if (const auto tried = tried_.find(corners); tried != tried_.end() && tried->second >= most_points)
      return give_up(t, "many points beside it did not help");
    // In a Delaunay mesh the circumcentre of a large triangle is at least half its longest edge away from all vertices.
    least_edge_ = attack.is_poor ? least : least_of_longest * longest;
    least_half_ = attack.is_poor && most_ratio_ >= 1 ? least_of_shortest * least : least_edge_;
    if (!insert_into(t, shortest, attack.is_poor)) {
      if (!attack.is_poor && split_longest(t)) return enqueue(t);  // what is too large can always be divided
      give_up(t, why_not_);
    } else if (mesh_.is_alive(t) && corners_of(mesh_, t) == corners) {
      if (attack.is_poor) ++tried_[corners];
      enqueue(t);
    }
  }

  /// Inserts the circumcentre of a triangle. For a poor one its off-centre is tried first: the point that makes the new
  /// triangle on the shortest edge just good enough (Üngör).
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

  /// Inserts p. Where a constrained edge stands between t and p, or p lies in the lens of one, splits that edge
  /// instead.
  bool insert_or_split(TriangleId t, const Point& p) {
    const HalfEdgeId wall = search_.walk_to(t, p);
    if (wall != none) {
      // If the circumcircle is empty and its centre lies beyond the wall, the wall is at least as long as its distance
      // from t. Where flips were refused the circumcircle may not be empty, and that is checked.
      double away = HUGE_VAL;
      for (int c = 0; c < 3; ++c) away = std::min(away, distance_from_chord(mesh_, wall, mesh_.corner(t, c)));
      return 2 * std::sqrt(squared(wall)) >= away ? split(wall) : refuse("its circumcentre lies beyond a curve");
    }
    if (const HalfEdgeId encroached = search_.find_encroached(search_.reached(), p); encroached != none)
      return split(encroached);
    const auto location = locator_.walk(p, search_.reached());
    if (!location) return refuse("no element was found at its circumcentre");
    const TriangleId k = location->triangle;
    double nearest = HUGE_VAL;
    for (int c = 0; c < 3; ++c) nearest = std::min(nearest, distance(mesh_.point(mesh_.corner(k, c)), p));
    if (nearest < std::max(floor_, least_edge_)) return refuse("its circumcentre is close to another vertex");
    if (mesh_.face(k) != mesh_.face(t)) return refuse("its circumcentre lies beyond a curve");
    const InsertResult inserted =
        insert_point(mesh_, k, location->xi, search_.edge_tolerance(k, location->xi, nearest));
    if (inserted.outcome != Outcome::done) return refuse(describe(inserted.outcome));
    ++tally_.insertions;
    settle(inserted.vertex);
    return true;
  }

  bool refuse(const char* reason) {
    why_not_ = reason;
    return false;
  }

  double squared(HalfEdgeId h) const {
    return squared_length(mesh_.point(mesh_.target(h)) - mesh_.point(mesh_.origin(h)));
  }
  bool split_longest(TriangleId t) {
    HalfEdgeId longest = half_edge(t, 0);
    for (int e = 1; e < 3; ++e)
      if (squared(half_edge(t, e)) > squared(longest)) longest = half_edge(t, e);
    return split(longest);
  }

  bool split(HalfEdgeId h) {
    const double half = std::sqrt(squared(h)) / 2;
    const bool on_curve = mesh_.is_constrained(h);
    if (half <= floor_) return refuse("at the least size");
    if (half < least_half_ && !(on_curve && half >= least_of_gap * gap_over(mesh_, h)))
      return refuse("an edge beside it would become shorter than its own");
    const double place = on_curve ? split_place(mesh_, h, corners_) : 0.5;
    const SplitPartner partner = on_curve ? find_partner(mesh_, h, corners_, place) : SplitPartner{};
    const PointId v = split_at(h, place);
    if (v == none) return false;
    if (partner) split_partner(partner, v);
    settle(v);
    return true;
  }
  /// Splits an edge; returns the new vertex, or none where that is refused.
  PointId split_at(HalfEdgeId h, double place) {
    const bool on_curve = mesh_.is_constrained(h);
    const PointId first = mesh_.origin(h), last = mesh_.target(h);
    const InsertResult result = split_edge(mesh_, h, place);
    if (result.outcome != Outcome::done) {
      refuse(describe(result.outcome));
      return none;
    }
    ++(on_curve ? tally_.splits : tally_.insertions);
    if (on_curve) corners_.add_between(result.vertex, first, last);
    return result.vertex;
  }
  /// Splits the partner of an edge that was split at v: as far from their common corner as v is.
  void split_partner(const SplitPartner& partner, PointId v) {
    const HalfEdgeId h = find_half_edge(mesh_, partner.first, partner.last);
    if (h == none || !mesh_.is_constrained(h)) return;
    const Point& corner = mesh_.point(partner.corner);
    const PointId w = split_at(h, place_at_radius(mesh_, h, corner, distance(corner, mesh_.point(v))));
    if (w != none) settle(w);
  }

  /// Restores the Delaunay property around a new vertex, then queues what changed.
  void settle(PointId v) {
    find_star(mesh_, v, star_);
    touched_.clear();
    for (const HalfEdgeId h : star_.outgoing) {
      stack_.push_back(next(h));
      touched_.push_back(triangle_of(h));
    }
    // Where an element's parameters run unevenly along a curve, subdivision bends the edges to the new vertex. The new
    // elements would then be far from their logical triangles, on which all decisions rest.
    bent_ = star_.outgoing;
    straighten_bent(mesh_, bent_, options_.refit);
    legalize(mesh_, stack_, options_.refit, tally_.flips, -1, &touched_, true);
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const TriangleId t : touched_) enqueue(t);
  }

  Mesh& mesh_;
  const RefineOptions& options_;
  Tally& tally_;
  Locator locator_;
  SharpCorners corners_;
  InsertionSearch search_;
  double floor_ = 0, most_ratio_ = 0;
  double least_edge_ = 0;          // no new point may be closer to another vertex
  double least_half_ = 0;          // no half of a split edge may be shorter
  const char* why_not_ = nullptr;  // the reason for which the last attempt was refused
  AttackQueue queue_;
  std::map<std::array<PointId, 3>, int> tried_;  // how many points were inserted for a triangle that stayed poor
  Star star_;
  std::vector<HalfEdgeId> stack_, bent_;
  std::vector<TriangleId> touched_;
};

Point middle_of(const Mesh& mesh, TriangleId t) {
  return (1.0 / 3) * (mesh.point(mesh.corner(t, 0)) + mesh.point(mesh.corner(t, 1)) + mesh.point(mesh.corner(t, 2)));
}

void Round::exceed(const Attack& attack) const {
  // The last vertex that was inserted shows where the work is.
  const Point& place = mesh_.point(mesh_.origin(star_.outgoing.front()));
  std::string text = "there are more than " + std::to_string(options_.max_triangles) +
                     " triangles, and elements near " + describe_point(place) + " are still " + attack.reason;
  text += attack.is_poor ? ": a gap there is thin, or an angle small (--thin keep leaves elements across thin gaps, "
                           "--min-size bounds their size, --min-angle 0 asks for no shape)"
                         : ": ask for larger elements";
  throw TooManyTriangles(text + ", or allow more (--max-triangles)");
}

/// Removes what would keep poor triangles from being flipped. False where none of `bad` is poor: nothing changes then.
bool tame_poor(Mesh& mesh, const RefineOptions& options, const std::vector<TriangleId>& bad, Tally& tally) {
  const std::vector<TriangleId> poor = find_poor(mesh, *options.goals, bad);
  if (poor.empty()) return false;
  long most = options.max_triangles;  // the last cut may still make one or two more
  if (options.max_insertions) most = std::min(most, mesh.triangle_count() + *options.max_insertions - tally.points());
  const TameCounts tamed = Tamer(mesh, options.refit, tally.flips).tame(poor, most);
  tally.insertions += tamed.splits;
  tally.splits += tamed.curve_splits;
  return true;
}

/// Those of `bad` that miss the goals.
std::vector<TriangleId> find_left(const Mesh& mesh, const QualityGoals& goals, const std::vector<TriangleId>& bad) {
  std::vector<TriangleId> left;
  for (const TriangleId t : bad)
    if (attack_on(mesh, t, goals).reason) left.push_back(t);
  return left;
}

PassReport report_of(const Mesh& mesh, const std::vector<TriangleId>& left, const Tally& tally) {
  PassReport report;
  report.add("insertions", static_cast<double>(tally.points()));
  report.add("interior_insertions", static_cast<double>(tally.insertions));
  report.add("curve_splits", static_cast<double>(tally.splits));
  report.add("flips", static_cast<double>(tally.flips.flips));
  report.add("left", static_cast<double>(left.size()));
  report.add("triangles", mesh.triangle_count());
  for (const TriangleId t : left) {
    const auto found = tally.left.find(Round::corners_of(mesh, t));
    const char* reason = found == tally.left.end() ? "as many points were inserted as asked" : found->second;
    report.refuse(reason, middle_of(mesh, t));
  }
  for (const auto& [reason, times] : tally.flips.refusals)
    report.refuse(std::string("flip: ") + describe(reason), times);
  return report;
}

}  // namespace

PassReport refine(Mesh& mesh, const RefineOptions& asked) {
  RefineOptions options = asked;
  if (!options.goals) options.goals = goals_of(mesh);
  if (options.progress != nullptr)
    options.progress->start("refine", "points", expected_insertions(mesh, *options.goals));
  std::vector<TriangleId> bad = find_bad(mesh, *options.goals);
  require_within_budget(mesh, *options.goals, options.max_triangles, bad);
  Tally tally;
  std::vector<TriangleId> left;
  long before = 0;
  do {
    before = tally.points();
    const bool is_tamed = tame_poor(mesh, options, bad, tally);
    if (is_tamed) bad = find_bad(mesh, *options.goals);
    tally.left.clear();
    if (!bad.empty()) Round(mesh, options, tally).run(bad);
    const bool is_unchanged = !is_tamed && tally.points() == before && mesh.is_compact();
    // With numbers in the order of insertion every later pass would jump from one end of the memory to the other.
    if ((tally.points() - before) * triangles_per_new_vertex > mesh.triangle_count())
      mesh.renumber();
    else
      mesh.compact();
    if (!is_unchanged) bad = find_bad(mesh, *options.goals);
    left = find_left(mesh, *options.goals, bad);
  } while (!left.empty() && tally.points() > before);
  return report_of(mesh, left, tally);
}

const char* refine_reason(const Mesh& mesh, TriangleId t, const QualityGoals& goals) {
  return attack_on(mesh, t, goals).reason;
}

}  // namespace pliant
