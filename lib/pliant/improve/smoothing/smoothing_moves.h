// lib/pliant/improve/smoothing/smoothing_moves.h: the ways to make an element less curved (private to smooth_curves).
#pragma once
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "pliant/improve/smooth_curves.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/trial_patch.h"
#include "pliant/quality/least_quality.h"

namespace pliant {

/// A change must lower an excess by at least this share of it: a cheap change, and one that takes long to find.
inline constexpr double least_gain = 0.01, least_long_gain = 0.05;
/// Compares two lists of excesses, each sorted from the greatest on. True if the first excess by which they differ is
/// lower in `now` than in `before` by at least the share `gain` of it. Of a tangled element's excess only the part
/// above 0.99 tangled_excess counts for the share: that part tells how far the element is turned over.
bool is_worth_it(std::span<const double> now, std::span<const double> before, double gain = least_gain);
/// How many of these excesses are those of tangled elements.
std::ptrdiff_t count_tangled(std::span<const double> excesses);

/// Tries changes around one element, and keeps those that lower the sorted list of the excesses of all elements that
/// they change (see smooth_curves).
class SmoothingMoves {
 public:
  SmoothingMoves(Mesh& mesh, const SmoothOptions& options);

  /// The excess of an element (CurvatureTest), and whether it is at most 1.
  double excess(TriangleId t) const;
  bool is_fine(TriangleId t) const;
  /// The excess as far as smoothing can change it: the angle by which an edge on a curve turns does not count.
  double movable_excess(TriangleId t) const;

  /// Each of these returns true if something changed; `touched` then has the elements that did.
  bool smooth_edges(TriangleId t);
  bool flip_edges(TriangleId t);
  bool move_vertices(TriangleId t);
  bool search_places(TriangleId t);
  /// Allows all searches together as many steps as so many elements may cost. When they are used up, search_places does
  /// nothing.
  void allow_searches(std::size_t elements);
  /// For an element whose logical triangle is turned over: moves a vertex or flips an edge, as the options allow, so
  /// that fewer logical triangles are turned over and no element is worse.
  bool turn_back(TriangleId t);
  /// From now on no change leaves an element below `floor` in shape or scaled Jacobian, unless the worst of the
  /// elements that it touches was below `floor` before and is no worse afterwards. No change leaves more elements
  /// invalid.
  void guard(const LeastQuality& floor) { floor_ = floor; }
  struct PatchQuality {
    LeastQuality least;
    int invalid = 0;
  };
  /// The quality of some elements as the mesh has them. Nothing is measured where nothing is guarded.
  PatchQuality quality_of(std::span<const TriangleId> elements) const;
  /// Is a change from `before` to `now` allowed by the guard?
  bool keeps(const PatchQuality& now, const PatchQuality& before) const;
  const std::vector<TriangleId>& touched() const { return touched_; }
  void forget_touched() { touched_.clear(); }

  long edges_smoothed = 0, flips = 0, vertices_moved = 0, searches = 0;
  std::map<std::string, long> refusals;

 private:
  template <class... Ways>
  bool take_best(double gain, std::span<const TriangleId> elements, const Ways&... ways);
  bool keeps_quality();
  unsigned fixed_edges(TriangleId t) const;
  double rating_of(std::size_t e) const;
  void rate_each(std::vector<double>& excesses) const;
  void rate(std::vector<double>& excesses) const;  // sorted from the worst
  bool rate_up_to(double most);
  bool place(std::span<const PointId> points, SmoothGoal goal, int rounds = 1);
  bool is_free(HalfEdgeId h) const;
  bool smooth_edge(HalfEdgeId h);
  bool smooth_all_edges(TriangleId t, bool straighten);
  bool smooth_interior(TriangleId t);
  bool move_vertex(PointId v, const Vector& away);
  Vector shift_of(PointId v);
  std::vector<double> excesses_of(std::span<const TriangleId> elements) const;  // sorted from the worst
  bool turn_back_by_vertex(PointId v);
  bool turn_back_by_flip(HalfEdgeId h);
  void collect_movable(TriangleId t);
  void add_movable_edges(TriangleId t);
  bool keep_if_better(PointId p, bool drags, const Vector& shift);

  Mesh& mesh_;
  const SmoothOptions& options_;
  CurvatureTest test_, content_test_;
  std::optional<LeastQuality> floor_;
  TrialPatch trial_;
  TrialPatch::Nets best_nets_;
  std::vector<double> before_, now_, best_, excesses_, trial_excesses_;
  std::vector<std::array<Point, 3>> triangles_;  // memory of shift_of
  std::vector<PlacementElement> straight_;
  std::vector<TriangleId> touched_, around_, on_trial_;
  std::vector<PointId> points_;
  long steps_left_ = 0;                            // steps that searches may still take
  std::vector<std::pair<PointId, bool>> movable_;  // points that a search moves, and whether each drags others along
  Star star_;
  bool is_tangled_ = false;  // some element on trial is tangled in the mesh
};

}  // namespace pliant
