// lib/pliant/improve/smoothing/search_places.cpp: the search of SmoothingMoves by small steps, where nothing else
// helps.
#include <algorithm>
#include <array>
#include <functional>

#include "pliant/improve/smoothing/smoothing_moves.h"
#include "pliant/ops/build_triangle.h"

namespace pliant {
namespace {

constexpr double first_step = 0.1, last_step = 2e-3;  // lengths of steps, relative to the element's size
constexpr int most_steps = 400;                       // steps of one search
/// How many steps all searches of a pass may take together, for each element that was too curved. A step costs about
/// p^4, and above degree 2 elements that nothing mends would take minutes.
int steps_per_element(int degree) { return degree <= 2 ? 4000 : 77000 / (degree * degree * degree * degree); }
constexpr double diagonal = 0.70710678118654752;
constexpr std::array<Vector, 8> directions{{{1, 0},
                                            {0, 1},
                                            {-1, 0},
                                            {0, -1},
                                            {diagonal, diagonal},
                                            {-diagonal, diagonal},
                                            {-diagonal, -diagonal},
                                            {diagonal, -diagonal}}};

template <typename T>
void add_once(std::vector<T>& list, const T& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

}  // namespace

void SmoothingMoves::allow_searches(std::size_t elements) {
  steps_left_ = static_cast<long>(elements) * steps_per_element(mesh_.degree());
}

/// Adds the points inside the free edges of an element to those that move, and the elements beside these edges to those
/// that change.
void SmoothingMoves::add_movable_edges(TriangleId t) {
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId h = half_edge(t, e);
    if (!is_free(h)) continue;
    add_once(around_, triangle_of(mesh_.twin(h)));
    for (int k = 1; k < mesh_.degree(); ++k) add_once(movable_, std::pair{mesh_.edge_point(h, k), false});
  }
}

/// Collects the points that a search for this element may move (movable_), and the elements that change with them
/// (around_).
void SmoothingMoves::collect_movable(TriangleId t) {
  around_.assign(1, t);
  movable_.clear();
  add_movable_edges(t);
  if (excess(t) >= tangled_excess)  // then the neighbours make room
    for (int e = 0; e < 3; ++e)
      if (is_free(half_edge(t, e))) add_movable_edges(triangle_of(mesh_.twin(half_edge(t, e))));
  for (int c = 0; c < 3 && options_.vertices; ++c) {
    const PointId v = mesh_.corner(t, c);
    find_star(mesh_, v, star_);
    if (!star_.is_closed || is_on_curve(mesh_, star_)) continue;
    for (const HalfEdgeId out : star_.outgoing) add_once(around_, triangle_of(out));
    movable_.emplace_back(v, true);
  }
  const InnerPoints inner = inner_points(mesh_, t);
  for (int k = 0; k < interior_size(mesh_.degree()); ++k)
    movable_.emplace_back(inner[static_cast<std::size_t>(k)], false);
}

/// Moves a point on the copies of the elements. Keeps the move if it lowers the sorted list of the excesses.
bool SmoothingMoves::keep_if_better(PointId p, bool drags, const Vector& shift) {
  best_nets_ = trial_.nets();
  if (drags)
    trial_.drag(p, shift);
  else
    trial_.move(p, trial_.point(p) + shift);
  trial_excesses_ = excesses_;
  bool is_worse = false;  // one is worse than the worst there was: the others need not be measured
  for (std::size_t e = 0; e < trial_.count() && !is_worse; ++e)
    if (trial_.has(e, p)) is_worse = (trial_excesses_[e] = rating_of(e)) > best_.front();
  if (!is_worse) {
    now_ = trial_excesses_;
    std::sort(now_.begin(), now_.end(), std::greater<>());
  }
  if (!is_worse && now_ < best_ && count_tangled(now_) <= count_tangled(before_) && keeps_quality()) {
    best_ = now_;
    excesses_ = trial_excesses_;
    return true;
  }
  trial_.set_nets(best_nets_);
  return false;
}

/// Pattern search (Hooke and Jeeves) for places of the element's own free points. It looks at the excesses themselves,
/// where optimal placement looks at one measure, which need not be the one that exceeds its bound.
bool SmoothingMoves::search_places(TriangleId t) {
  if (steps_left_ <= 0) return false;
  collect_movable(t);
  Box box;
  for (int c = 0; c < 3; ++c) box.extend(mesh_.point(mesh_.corner(t, c)));
  trial_.capture(mesh_, around_);
  rate_each(excesses_);
  before_ = excesses_;
  std::sort(before_.begin(), before_.end(), std::greater<>());
  if (before_.front() <= 1) return false;
  best_ = before_;
  int steps = 0;
  for (double step = first_step; step > last_step && steps < most_steps; step /= 2)
    for (bool found = true; found && steps < most_steps;) {
      found = false;
      for (const auto& [p, drags] : movable_)
        for (const Vector& direction : directions) {
          ++steps;
          if (!keep_if_better(p, drags, step * box.size() * direction)) continue;
          found = true;
          break;
        }
    }
  steps_left_ -= steps;
  if (!is_worth_it(best_, before_, before_.front() < tangled_excess ? least_long_gain : least_gain)) return false;
  if (trial_.apply(mesh_, options_.refit, best_.front() < tangled_excess) != Outcome::done) return false;
  touched_.insert(touched_.end(), around_.begin(), around_.end());
  ++searches;
  return true;
}

}  // namespace pliant
