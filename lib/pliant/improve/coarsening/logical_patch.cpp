// lib/pliant/improve/coarsening/logical_patch.cpp: cuts the ears of a star, then flips, on copied straight triangles.
#include "pliant/improve/coarsening/logical_patch.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/geometry/predicates.h"
#include "pliant/improve/edge_bend.h"
#include "pliant/improve/legalize.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/removal/merge.h"

namespace pliant {
namespace {

constexpr int most_flips = 60;   // flips after one removal
constexpr int most_degree = 40;  // triangles around a vertex that is removed

int outside_piece(HalfEdgeId h) { return -2 - as_int(h); }
HalfEdgeId half_edge_of(int beyond) { return HalfEdgeId{-2 - beyond}; }

}  // namespace

/// Copies a triangle of the mesh that is not here yet, and joins it to the pieces that border on it.
int LogicalPatch::bring_in(TriangleId t) {
  const int now = static_cast<int>(pieces_.size());
  Piece copy;
  copy.is_alive = true;
  copy.face = mesh_.face(t);
  copy.triangle = t;
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId h = half_edge(t, e), g = mesh_.twin(h);
    if (measures_) squared_bend_ = std::max(squared_bend_, squared_bend(mesh_, h));
    copy.corners[index(e)] = mesh_.origin(h);
    copy.is_constrained[index(e)] = mesh_.is_constrained(h);
    copy.beyond[index(e)] = g == none ? wall : outside_piece(g);
  }
  for (int p = 0; p < now; ++p) {
    Piece& other = piece(p);
    for (std::size_t f = 0; f < 3 && other.is_alive; ++f) {
      if (other.beyond[f] >= wall) continue;
      const HalfEdgeId h = half_edge_of(other.beyond[f]);
      if (triangle_of(h) != t) continue;
      other.beyond[f] = now;
      copy.beyond[index(edge_of(h))] = p;
    }
  }
  pieces_.push_back(copy);
  return now;
}

int LogicalPatch::side_towards(int p, PointId origin) const {
  const Corners& corners = pieces_[index(p)].corners;
  return corners[0] == origin ? 0 : corners[1] == origin ? 1 : 2;
}

/// Joins a side of a piece to what is beyond it, and that to the piece.
void LogicalPatch::set_beyond(int p, int side, int beyond, bool is_constrained) {
  piece(p).beyond[index(side)] = beyond;
  piece(p).is_constrained[index(side)] = is_constrained;
  if (beyond >= 0)  // its side runs the other way
    piece(beyond).beyond[index(side_towards(beyond, piece(p).corners[index((side + 1) % 3)]))] = p;
}

/// Some piece with this corner; brings one in if there is none.
int LogicalPatch::piece_at(PointId v) {
  for (int p = 0; p < static_cast<int>(pieces_.size()); ++p)
    if (piece(p).is_alive && std::find(piece(p).corners.begin(), piece(p).corners.end(), v) != piece(p).corners.end())
      return p;
  return bring_in(triangle_of(mesh_.vertex_half_edge(v)));
}

int LogicalPatch::neighbor(int p, int side) {
  const int beyond = piece(p).beyond[index(side)];
  return beyond >= 0 ? beyond : bring_in(triangle_of(half_edge_of(beyond)));
}

/// Turns a piece so that v is its corner 0.
void LogicalPatch::turn(int p, PointId v) {
  Piece& here = piece(p);
  const int c = side_towards(p, v);
  std::rotate(here.corners.begin(), here.corners.begin() + c, here.corners.end());
  std::rotate(here.beyond.begin(), here.beyond.begin() + c, here.beyond.end());
  std::rotate(here.is_constrained.begin(), here.is_constrained.begin() + c, here.is_constrained.end());
}

LogicalPatch::Outcome LogicalPatch::gather_ring(PointId v) {
  ring_.clear();
  const int first = piece_at(v);
  for (int p = first;;) {
    turn(p, v);
    ring_.push_back(p);
    if (piece(p).beyond[2] == wall || piece(p).is_constrained[2]) return Outcome::on_curve;
    if (static_cast<int>(ring_.size()) > most_degree) return Outcome::unknown;
    p = neighbor(p, 2);
    if (p == first) return Outcome::done;
  }
}

/// Collects the pieces around v on p's side of the curve; false if there are too many.
bool LogicalPatch::gather_fan(int p, PointId v) {
  const auto ends = [this](int q, int side) {
    return piece(q).beyond[index(side)] == wall || piece(q).is_constrained[index(side)];
  };
  turn(p, v);
  for (int steps = 0; !ends(p, 0); ++steps) {
    if (steps > most_degree) return false;
    p = neighbor(p, 0);
    turn(p, v);
  }
  ring_.assign(1, p);
  while (!ends(p, 2)) {
    if (static_cast<int>(ring_.size()) > most_degree) return false;
    p = neighbor(p, 2);
    turn(p, v);
    ring_.push_back(p);
  }
  return true;
}

/// Cuts off the deepest ear that a flip can cut, as `reduce_fan` does; false if there is none.
bool LogicalPatch::cut_ear(bool is_closed) {
  const int count = static_cast<int>(ring_.size());
  const Point& v = place(piece(ring_[0]).corners[0]);
  const auto link = [&](int i) -> const Point& {
    return i == count && !is_closed ? place(piece(ring_[index(count - 1)]).corners[2])
                                    : place(piece(ring_[index((i + count) % count)]).corners[1]);
  };
  ears_.clear();
  for (int i = is_closed ? 0 : 1; i < count; ++i) {
    const Point &a = link(i - 1), &b = link(i), &c = link(i + 1);
    if (cross(b - a, c - a) > 0) ears_.emplace_back(depth_in_circle(a, b, c, v), i);
  }
  std::sort(ears_.begin(), ears_.end());
  for (const auto& [depth, i] : ears_) {
    const Point &a = link(i - 1), &b = link(i), &c = link(i + 1);
    if (orient2d(v, a, c) <= 0 || orient2d(a, b, c) <= 0) continue;
    flip(ring_[index((i + count - 1) % count)], 2);
    ring_.erase(ring_.begin() + i);
    return true;
  }
  return false;
}

/// Flips the side that p shares with another piece q. Afterwards p lies around the old side's target, q around its
/// origin, which become their corner 0.
void LogicalPatch::flip(int p, int side) {
  const int q = piece(p).beyond[index(side)];
  const Piece old_p = piece(p), old_q = piece(q);
  const PointId a = old_p.corners[index(side)], b = old_p.corners[index((side + 1) % 3)];
  const int f = side_towards(q, b);
  const PointId c = old_p.corners[index((side + 2) % 3)], d = old_q.corners[index((f + 2) % 3)];
  // The side from a to b becomes one from d to c: q keeps a, d, c and p keeps b, c, d, or the other way round.
  const auto fill = [&](int to, const Corners& corners, const Piece& one, int one_side, const Piece& two, int two_side,
                        int other) {
    Piece& now = piece(to);
    now.corners = corners;
    now.beyond = {one.beyond[index(one_side)], other, two.beyond[index(two_side)]};
    now.is_constrained = {one.is_constrained[index(one_side)], false, two.is_constrained[index(two_side)]};
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
  now.is_new = true;
  piece(merged) = now;
  piece(ring_[1]).is_alive = false;
  for (int e = 0; e < 2; ++e) set_beyond(merged, e, now.beyond[index(e)], now.is_constrained[index(e)]);
  return merged;
}

void LogicalPatch::bring_in_star(PointId v) {
  find_star(mesh_, v, star_);
  for (const HalfEdgeId h : star_.outgoing)
    if (std::none_of(pieces_.begin(), pieces_.end(),
                     [t = triangle_of(h)](const Piece& each) { return each.triangle == t; }))
      bring_in(triangle_of(h));
}

bool LogicalPatch::has_moved(const Piece& piece) const {
  return std::any_of(moved_.begin(), moved_.end(), [&](const auto& each) {
    return std::find(piece.corners.begin(), piece.corners.end(), each.first) != piece.corners.end();
  });
}

LogicalPatch::Outcome LogicalPatch::flip_to_delaunay() {
  for (int flips = 0; !stack_.empty();) {
    const int p = stack_.back() / 3, side = stack_.back() % 3;
    stack_.pop_back();
    if (!piece(p).is_alive || piece(p).is_constrained[index(side)] || piece(p).beyond[index(side)] == wall) continue;
    const int beyond = piece(p).beyond[index(side)];
    const Corners& corners = piece(p).corners;
    const PointId a = corners[index(side)], b = corners[index((side + 1) % 3)], c = corners[index((side + 2) % 3)];
    const PointId d = beyond >= 0 ? piece(beyond).corners[index((side_towards(beyond, b) + 2) % 3)]
                                  : mesh_.apex(half_edge_of(beyond));
    if (!wants_flip(edge_state(place(a), place(b), place(c), place(d)))) continue;
    if (++flips > most_flips) return Outcome::unknown;
    const int q = beyond >= 0 ? beyond : bring_in(triangle_of(half_edge_of(beyond)));
    flip(p, side);
    for (const int both : {p, q})
      for (const int e : {0, 2}) stack_.push_back(3 * both + e);
  }
  return Outcome::done;
}

LogicalPatch::Outcome LogicalPatch::remove_inner(PointId v) {
  if (const Outcome outcome = gather_ring(v); outcome != Outcome::done) return outcome;
  hole_ = ring_;
  while (ring_.size() > 3)
    if (!cut_ear(true)) return Outcome::stuck;
  if (ring_.size() < 3) return Outcome::stuck;
  merge_ring();
  stack_.clear();
  for (const int p : hole_)
    if (piece(p).is_alive)
      for (int e = 0; e < 3; ++e) stack_.push_back(3 * p + e);
  return flip_to_delaunay();
}

LogicalPatch::Outcome LogicalPatch::remove_on_curve(PointId v, const std::vector<std::pair<PointId, Point>>& moved) {
  link_.clear();
  const auto reduce = [this, v](int p) {
    if (!gather_fan(p, v)) return Outcome::unknown;
    for (const int q : ring_) link_.insert(link_.end(), {piece(q).corners[1], piece(q).corners[2]});
    while (ring_.size() > 2)
      if (!cut_ear(false)) return Outcome::stuck;
    return ring_.size() == 2 ? Outcome::done : Outcome::stuck;
  };
  if (const Outcome outcome = reduce(piece_at(v)); outcome != Outcome::done) return outcome;
  if (piece(ring_[0]).beyond[0] == wall) {
    merge_fan();
  } else {
    const std::array<int, 2> near{ring_[0], ring_[1]};
    if (const Outcome outcome = reduce(neighbor(near[0], 0)); outcome != Outcome::done) return outcome;
    const int far = merge_fan();
    ring_.assign(near.begin(), near.end());
    const int merged = merge_fan();
    piece(merged).beyond[2] = far;
    piece(far).beyond[2] = merged;
  }
  moved_ = moved;
  for (const auto& [w, to] : moved) link_.push_back(w);
  for (const PointId w : link_) bring_in_star(w);
  stack_.clear();
  for (int q = 0; q < static_cast<int>(pieces_.size()); ++q)
    if (piece(q).is_alive)
      for (int e = 0; e < 3; ++e) stack_.push_back(3 * q + e);
  return flip_to_delaunay();
}

}  // namespace pliant
