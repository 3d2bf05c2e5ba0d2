// lib/pliant/improve/coarsening/logical_patch_copies.cpp: triangles of the mesh copied into a patch, and joined there.
#include <algorithm>

#include "pliant/improve/coarsening/logical_patch.h"
#include "pliant/improve/edge_bend.h"
#include "pliant/mesh/star.h"

namespace pliant {

int LogicalPatch::number_of(PointId v) const {
  const auto found = std::find(vertices_.begin(), vertices_.end(), v);
  return found == vertices_.end() ? none : static_cast<int>(found - vertices_.begin());
}

Point LogicalPatch::place_of(PointId v) const {
  for (const auto& [moved, to] : moved_)
    if (moved == v) return to;
  return mesh_.point(v);
}

int LogicalPatch::add_vertex(PointId v) {
  vertices_.push_back(v);
  places_.push_back(place_of(v));
  return static_cast<int>(vertices_.size()) - 1;
}

int LogicalPatch::copy(TriangleId t, const Corners& corners) {
  Piece& now = pieces_.emplace_back();
  now.corners = corners;
  now.is_alive = true;
  now.face = mesh_.face(t);
  now.triangle = t;
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId h = half_edge(t, e), g = mesh_.twin(h);
    if (measures_) squared_bend_ = std::max(squared_bend_, squared_bend(mesh_, h));
    now.is_constrained[index(e)] = mesh_.is_constrained(h);
    now.beyond[index(e)] = g == none ? wall : outside_piece(g);
  }
  return static_cast<int>(pieces_.size()) - 1;
}

/// Joins these sides of the last piece, p, to the pieces that border on them.
void LogicalPatch::join(int p, const std::array<bool, 3>& sides) {
  if (!sides[0] && !sides[1] && !sides[2]) return;
  Piece& here = piece(p);
  for (int q = 0; q < p; ++q) {
    Piece& other = piece(q);
    for (std::size_t f = 0; f < 3 && other.is_alive; ++f) {
      if (other.beyond[f] >= wall) continue;
      const HalfEdgeId h = half_edge_of(other.beyond[f]);
      if (triangle_of(h) != here.triangle) continue;
      other.beyond[f] = p;
      here.beyond[index(edge_of(h))] = q;
    }
  }
}

/// Copies a triangle of the mesh that is not here yet, and joins it to the pieces that border on it.
int LogicalPatch::bring_in(TriangleId t) {
  Corners corners;
  std::array<bool, 3> is_known;
  for (std::size_t c = 0; c < 3; ++c) {
    const PointId v = mesh_.corner(t, static_cast<int>(c));
    corners[c] = number_of(v);
    is_known[c] = corners[c] != none;
    if (!is_known[c]) corners[c] = add_vertex(v);
  }
  const int now = copy(t, corners);
  join(now, {is_known[0] && is_known[1], is_known[1] && is_known[2], is_known[2] && is_known[0]});
  return now;
}

/// The same for the triangle beyond a side of piece p.
int LogicalPatch::bring_in_beside(int p, int side) {
  const HalfEdgeId h = half_edge_of(piece(p).beyond[index(side)]);
  const auto e = index(edge_of(h));
  const PointId apex = mesh_.apex(h);
  Corners corners;
  corners[e] = piece(p).corners[index((side + 1) % 3)];
  corners[(e + 1) % 3] = piece(p).corners[index(side)];
  const int known = number_of(apex);
  corners[(e + 2) % 3] = known == none ? add_vertex(apex) : known;
  const int now = copy(triangle_of(h), corners);
  piece(now).beyond[e] = p;
  piece(p).beyond[index(side)] = now;
  if (known != none) join(now, {true, true, true});  // otherwise no other piece borders on it
  return now;
}

int LogicalPatch::side_towards(int p, int corner) const {
  const Corners& corners = pieces_[index(p)].corners;
  return corners[0] == corner ? 0 : corners[1] == corner ? 1 : 2;
}

/// Joins a side of a piece to what is beyond it, and that to the piece.
void LogicalPatch::set_beyond(int p, int side, int beyond, bool is_constrained) {
  piece(p).beyond[index(side)] = beyond;
  piece(p).is_constrained[index(side)] = is_constrained;
  if (beyond < 0) return;
  const auto back = index(side_towards(beyond, piece(p).corners[index((side + 1) % 3)]));  // it runs the other way
  piece(beyond).beyond[back] = p;
  piece(beyond).is_settled[back] = false;
}

/// Some piece with this corner; brings one in if there is none.
int LogicalPatch::piece_at(PointId v) {
  if (const int k = number_of(v); k != none)
    for (int p = 0; p < static_cast<int>(pieces_.size()); ++p)
      if (const Corners& c = piece(p).corners; piece(p).is_alive && (c[0] == k || c[1] == k || c[2] == k)) return p;
  return bring_in(triangle_of(mesh_.vertex_half_edge(v)));
}

/// Turns a piece so that this corner is its corner 0.
void LogicalPatch::turn(int p, int corner) {
  Piece& here = piece(p);
  const int c = side_towards(p, corner);
  if (c == 0) return;
  const auto rotate = [c](auto& all) {
    const auto old = all;
    for (std::size_t k = 0; k < 3; ++k) all[k] = old[(k + index(c)) % 3];
  };
  rotate(here.corners);
  rotate(here.beyond);
  rotate(here.is_constrained);
  rotate(here.is_settled);
}

void LogicalPatch::bring_in_star(PointId v) {
  find_star(mesh_, v, star_);
  for (const HalfEdgeId h : star_.outgoing)
    if (std::none_of(pieces_.begin(), pieces_.end(),
                     [t = triangle_of(h)](const Piece& each) { return each.triangle == t; }))
      bring_in(triangle_of(h));
}

}  // namespace pliant
