#include <algorithm>  // lib/pliant/improve/turn_back.cpp: straight triangles that are turned over, under elements valid or not
#include <array>
#include <functional>

#include "pliant/geometry/predicates.h"
#include "pliant/improve/smoothing_moves.h"
#include "pliant/ops/flip_edge.h"

namespace pliant {
namespace {

bool is_turned_over(const Point& a, const Point& b, const Point& c) { return orient2d(a, b, c) <= 0; }

/// No element is worse for it, from the worst on; what is fine may become less so.
bool is_no_worse(std::span<const double> now, std::span<const double> before) {
  for (std::size_t k = 0; k < now.size(); ++k) {
    const double a = std::max(1.0, now[k]), b = std::max(1.0, before[k]);
    if (a != b) return a < b;
  }
  return true;
}

}  // namespace

bool SmoothingMoves::is_turned_over(TriangleId t) const {
  return pliant::is_turned_over(mesh_.point(mesh_.corner(t, 0)), mesh_.point(mesh_.corner(t, 1)),
                                mesh_.point(mesh_.corner(t, 2)));
}

bool SmoothingMoves::turn_back(TriangleId t) {
  if (options_.vertices)
    for (int c = 0; c < 3; ++c)
      if (turn_back_by_vertex(mesh_.corner(t, c))) return true;
  if (options_.flips)
    for (int e = 0; e < 3; ++e)
      if (turn_back_by_flip(half_edge(t, e))) return true;
  return false;
}

/// Fewer of the straight triangles around the vertex are turned over, and the elements are no worse.
bool SmoothingMoves::turn_back_by_vertex(PointId v) {
  find_star(mesh_, v, star_);
  if (!star_.is_closed || is_on_curve(mesh_, star_)) return false;
  around_.clear();
  for (const HalfEdgeId h : star_.outgoing) around_.push_back(triangle_of(h));
  const Vector best = shift_of(v);
  trial_.capture(mesh_, around_);
  const auto count_turned_over = [this] {
    int count = 0;
    for (std::size_t e = 0; e < trial_.count(); ++e) {
      const auto net = trial_.net(e);
      count += pliant::is_turned_over(net[0], net[1], net[2]);
    }
    return count;
  };
  const int turned_over = count_turned_over();
  rate(before_);
  for (const bool straight : {true, false})
    for (const double share : {1.0, 0.7, 0.5, 0.3}) {
      trial_.reset();
      trial_.drag(v, share * best);
      if (count_turned_over() >= turned_over) continue;
      for (const HalfEdgeId h : star_.outgoing)
        if (straight) trial_.straighten(mesh_, h, 0);
      rate(now_);
      if (count_tangled(now_) > count_tangled(before_) || !is_no_worse(now_, before_)) continue;
      if (trial_.apply(mesh_, options_.refit, now_.front() < tangled_excess) != Refusal::done) continue;
      touched_.insert(touched_.end(), around_.begin(), around_.end());
      return true;
    }
  return false;
}

bool SmoothingMoves::turn_back_by_flip(HalfEdgeId h) {
  if (mesh_.twin(h) == none || mesh_.is_constrained(h)) return false;
  const std::array<TriangleId, 2> pair{triangle_of(h), triangle_of(mesh_.twin(h))};
  const auto rate_pair = [&](std::vector<double>& excesses) {
    excesses = {movable_excess(pair[0]), movable_excess(pair[1])};
    std::sort(excesses.begin(), excesses.end(), std::greater<>());
  };
  rate_pair(before_);
  Transaction trial(mesh_);
  if (flip_edge(mesh_, h, options_.refit) != Refusal::done) return false;  // both new straight triangles are positive
  rate_pair(now_);
  if (count_tangled(now_) > count_tangled(before_) || !is_no_worse(now_, before_)) return false;
  trial.commit();
  touched_.insert(touched_.end(), pair.begin(), pair.end());
  ++flips;
  return true;
}

}  // namespace pliant
