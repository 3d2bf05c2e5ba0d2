// lib/pliant/improve/coarsening/logical_patch.cpp: cuts the ears of a star, then flips, on copied straight triangles.
#include "pliant/improve/coarsening/logical_patch.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/geometry/predicates.h"
#include "pliant/improve/legalize.h"
#include "pliant/ops/removal/merge.h"

namespace pliant {
namespace {

constexpr int most_flips = 60;   // flips after one removal
constexpr int most_degree = 40;  // triangles around a vertex that is removed

}  // namespace

LogicalPatch::Outcome LogicalPatch::gather_ring(PointId v) {
  ring_.clear();
  const int first = piece_at(v), corner = number_of(v);
  for (int p = first;;) {
    turn(p, corner);
    ring_.push_back(p);
    if (piece(p).beyond[2] == wall || piece(p).is_constrained[2]) return Outcome::on_curve;
    if (static_cast<int>(ring_.size()) > most_degree) return Outcome::unknown;
    p = neighbor(p, 2);
    if (p == first) return Outcome::done;
  }
}

/// Collects the pieces around a corner on p's side of the curve; false if there are too many.
bool LogicalPatch::gather_fan(int p, int corner) {
  const auto ends = [this](int q, int side) {
    return piece(q).beyond[index(side)] == wall || piece(q).is_constrained[index(side)];
  };
  turn(p, corner);
  for (int steps = 0; !ends(p, 0); ++steps) {
    if (steps > most_degree) return false;
    p = neighbor(p, 0);
    turn(p, corner);
  }
  ring_.assign(1, p);
  while (!ends(p, 2)) {
    if (static_cast<int>(ring_.size()) > most_degree) return false;
    p = neighbor(p, 2);
    turn(p, corner);
    ring_.push_back(p);
  }
  return true;
}

/// Cuts off ears until `least` pieces are left in the ring, the deepest ear that a flip can cut first, as `reduce_fan`
/// does. False if at some point there is none, or there were too few pieces.
bool LogicalPatch::reduce_ring(bool is_closed, int least) {
  int count = static_cast<int>(ring_.size());
  if (count <= least) return count == least;
  const Point v = place(piece(ring_[0]).corners[0]);
  // Ear i is the triangle of places i, i + 1, i + 2: a link vertex between its two neighbours. In a closed ring the
  // link's last vertex comes first, too, and the first one last.
  link_.clear();
  if (is_closed) link_.push_back(place(piece(ring_.back()).corners[1]));
  for (const int p : ring_) link_.push_back(place(piece(p).corners[1]));
  link_.push_back(is_closed ? link_[1] : place(piece(ring_.back()).corners[2]));
  const auto depth_of = [&](int i) {  // infinite where no flip can cut the ear
    const Point &a = link_[index(i)], &b = link_[index(i + 1)], &c = link_[index(i + 2)];
    return cross(b - a, c - a) > 0 ? depth_in_circle(a, b, c, v) : HUGE_VAL;
  };
  ears_.clear();
  for (int i = 0; i + 2 < static_cast<int>(link_.size()); ++i) ears_.push_back(depth_of(i));
  const int first = is_closed ? 0 : 1;  // the place in the ring of the piece after the spoke to ear 0
  for (;;) {
    const auto best = static_cast<int>(std::min_element(ears_.begin(), ears_.end()) - ears_.begin());
    if (ears_.empty() || !(ears_[index(best)] < HUGE_VAL)) return false;
    const Point &a = link_[index(best)], &b = link_[index(best + 1)], &c = link_[index(best + 2)];
    if (orient2d(v, a, c) <= 0 || orient2d(a, b, c) <= 0) {
      ears_[index(best)] = HUGE_VAL;
      continue;
    }
    const int after = best + first;
    flip(ring_[index((after + count - 1) % count)], 2);
    ring_.erase(ring_.begin() + after);
    if (--count == least) return true;
    ears_.erase(ears_.begin() + best);
    link_.erase(link_.begin() + best + 1);
    if (is_closed) {
      link_.front() = link_[link_.size() - 2];
      link_.back() = link_[1];
      ears_[index((best + count - 1) % count)] = depth_of((best + count - 1) % count);
      ears_[index(best % count)] = depth_of(best % count);
    } else {
      if (best > 0) ears_[index(best - 1)] = depth_of(best - 1);
      if (index(best) < ears_.size()) ears_[index(best)] = depth_of(best);
    }
  }
}

/// Flips the side that p shares with another piece q. Afterwards p lies around
/// the old side's target, q around its origin, which become their corner 0.
void LogicalPatch::flip(int p, int side) {
  const int q = piece(p).beyond[index(side)];
  const Piece old_p = piece(p), old_q = piece(q);
  const int a = old_p.corners[index(side)], b = old_p.corners[index((side + 1) % 3)];
  const int f = side_towards(q, b);
  const int c = old_p.corners[index((side + 2) % 3)], d = old_q.corners[index((f + 2) % 3)];
  // The side from a to b becomes one from d to c: q keeps a, d, c and p keeps b, c, d, or the other way round.
  const auto fill = [&](int to, const Corners& corners, const Piece& one, int one_side, const Piece& two, int two_side,
                        int other) {
    Piece& now = piece(to);
    now.corners = corners;
    now.beyond = {one.beyond[index(one_side)], other, two.beyond[index(two_side)]};
    now.is_constrained = {one.is_constrained[index(one_side)], false, two.is_constrained[index(two_side)]};
    now.is_settled = {};
    now.is_new = true;
  };
  // Around b: (b, c, d) with b c from p and d b from q. Around a: (a, d, c) with a d from q and c a from p.
  fill(p, {b, c, d}, old_p, (side + 1) % 3, old_q, (f + 2) % 3, q);
  fill(q, {a, d, c}, old_q, (f + 1) % 3, old_p, (side + 2) % 3, p);
  for (const int to : {p, q})
    for (const int e : {0, 2}) set_beyond(to, e, piece(to).beyond[index(e)], piece(to).is_constrained[index(e)]);
}

/// Merges the three pieces that are left around a vertex into one.
void LogicalPatch::merge_ring() {
  const Piece one = piece(ring_[1]), two = piece(ring_[2]);
  const int merged = ring_[0];
  Piece now = piece(merged);
  now.corners = {now.corners[1], one.corners[1], two.corners[1]};
  now.beyond = {now.beyond[1], one.beyond[1], two.beyond[1]};
  now.is_constrained = {now.is_constrained[1], one.is_constrained[1], two.is_constrained[1]};
  now.is_settled = {};
  now.is_new = true;
  piece(merged) = now;
  piece(ring_[1]).is_alive = piece(ring_[2]).is_alive = false;
  for (int e = 0; e < 3; ++e) set_beyond(merged, e, now.beyond[index(e)], now.is_constrained[index(e)]);
}

/// Merges the two pieces that are left on one side of a curve into one, whose side 2 lies on the curve.
int LogicalPatch::merge_fan() {
  const Piece other = piece(ring_[1]);
  const int merged = ring_[0];
  Piece now = piece(merged);
  now.corners = {now.corners[1], now.corners[2], other.corners[2]};
  now.beyond = {now.beyond[1], other.beyond[1], wall};
  now.is_constrained = {now.is_constrained[1], other.is_constrained[1], true};
  now.is_settled = {};
  now.is_new = true;
  piece(merged) = now;
  piece(ring_[1]).is_alive = false;
  for (int e = 0; e < 2; ++e) set_beyond(merged, e, now.beyond[index(e)], now.is_constrained[index(e)]);
  return merged;
}

bool LogicalPatch::has_moved(const Piece& piece) const {
  return std::any_of(moved_.begin(), moved_.end(), [&](const auto& each) {
    const std::array<PointId, 3> corners = vertices(piece);
    return std::find(corners.begin(), corners.end(), each.first) != corners.end();
  });
}

/// Does edge_state ask for a flip of this side, which is on no curve?
bool LogicalPatch::wants_flip(int p, int side) {
  Piece& here = piece(p);
  const int beyond = here.beyond[index(side)], origin = here.corners[index((side + 1) % 3)];
  const Point &a = place(here.corners[index(side)]), &b = place(origin),
              &c = place(here.corners[index((side + 2) % 3)]);
  int back = 0;
  const bool is_here = beyond >= 0;
  if (is_here) back = side_towards(beyond, origin);
  const Point d =
      is_here ? place(piece(beyond).corners[index((back + 2) % 3)]) : place_of(mesh_.apex(half_edge_of(beyond)));
  if (pliant::wants_flip(edge_state(a, b, c, d))) return true;
  here.is_settled[index(side)] = true;
  if (is_here) piece(beyond).is_settled[index(back)] = true;
  return false;
}

LogicalPatch::Outcome LogicalPatch::flip_to_delaunay() {
  for (int flips = 0; !stack_.empty();) {
    const int p = stack_.back() / 3, side = stack_.back() % 3;
    stack_.pop_back();
    const Piece& here = piece(p);
    if (!here.is_alive || here.is_constrained[index(side)] || here.beyond[index(side)] == wall) continue;
    if (here.is_settled[index(side)] || !wants_flip(p, side)) continue;
    if (++flips > most_flips) return Outcome::unknown;
    const int q = neighbor(p, side);
    flip(p, side);
    for (const int both : {p, q})
      for (const int e : {0, 2}) stack_.push_back(3 * both + e);
  }
  return Outcome::done;
}

LogicalPatch::Outcome LogicalPatch::remove_inner(PointId v) {
  if (const Outcome outcome = gather_ring(v); outcome != Outcome::done) return outcome;
  hole_ = ring_;
  if (!reduce_ring(true, 3)) return Outcome::stuck;
  merge_ring();
  stack_.clear();
  for (const int p : hole_)
    if (piece(p).is_alive)
      for (int e = 0; e < 3; ++e) stack_.push_back(3 * p + e);
  return flip_to_delaunay();
}

LogicalPatch::Outcome LogicalPatch::remove_on_curve(PointId v, const std::vector<std::pair<PointId, Point>>& moved) {
  rim_.clear();
  const auto reduce = [this](int p, int corner) {
    if (!gather_fan(p, corner)) return Outcome::unknown;
    for (const int q : ring_)
      for (const int c : {1, 2}) rim_.push_back(vertices_[index(piece(q).corners[index(c)])]);
    return reduce_ring(false, 2) ? Outcome::done : Outcome::stuck;
  };
  const int start = piece_at(v), corner = number_of(v);
  if (const Outcome outcome = reduce(start, corner); outcome != Outcome::done) return outcome;
  if (piece(ring_[0]).beyond[0] == wall) {
    merge_fan();
  } else {
    const std::array<int, 2> near{ring_[0], ring_[1]};
    if (const Outcome outcome = reduce(neighbor(near[0], 0), corner); outcome != Outcome::done) return outcome;
    const int far = merge_fan();
    ring_.assign(near.begin(), near.end());
    const int merged = merge_fan();
    piece(merged).beyond[2] = far;
    piece(far).beyond[2] = merged;
  }
  moved_ = moved;
  for (const auto& [w, to] : moved) {
    rim_.push_back(w);
    if (const int k = number_of(w); k != none) places_[index(k)] = to;
  }
  for (Piece& each : pieces_) each.is_settled = {};
  for (const PointId w : rim_) bring_in_star(w);
  stack_.clear();
  for (int q = 0; q < static_cast<int>(pieces_.size()); ++q)
    if (piece(q).is_alive)
      for (int e = 0; e < 3; ++e) stack_.push_back(3 * q + e);
  return flip_to_delaunay();
}

}  // namespace pliant
