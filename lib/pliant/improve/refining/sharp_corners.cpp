// lib/pliant/improve/refining/sharp_corners.cpp: finds corners by the angles of tangents, sides by walks along curves.
#include "pliant/improve/refining/sharp_corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

constexpr FaceId several = -2;                 // the "face" of a corner that has small angles in several faces
constexpr double wide = std::numbers::pi / 3;  // radians: every wedge is narrower than this
constexpr double narrow = 0.175;               // radians: a wedge is left as it is wherever it is narrower
// Bounds within which a wedge excuses a triangle, by the distances of the triangle's corners from that of the wedge:
constexpr double most_ratio =
    2.1;  // in a narrow wedge: the larger distance of the shortest edge's ends over the smaller
constexpr double same_distance = 1.2;  // elsewhere: the same ratio, so that both ends are on one shell
constexpr double corner_reach = 1.95;  // elsewhere: the least distance of a corner, in longest edges of the triangle
constexpr double most_extent = 3;      // elsewhere: the triangle's longest edge, in radii of the shell

/// The direction in which an edge leaves its origin (`reversed`: its target): the first leg of its control polygon that
/// has a length.
Vector direction(const Mesh& mesh, HalfEdgeId h, bool reversed) {
  const int p = mesh.degree();
  const Point& origin = mesh.point(mesh.edge_point(h, reversed ? p : 0));
  for (int k = 1; k <= p; ++k) {
    const Point& b = mesh.point(mesh.edge_point(h, reversed ? p - k : k));
    if (!(b == origin)) return b - origin;
  }
  return {};
}

bool is_below_sixty(const Vector& a, const Vector& b) {
  return dot(a, b) > 0 && std::fabs(cross(a, b)) < std::numbers::sqrt3 * dot(a, b);
}

double logical_angle(const Mesh& mesh, HalfEdgeId h) {
  const Point& v = mesh.point(mesh.origin(h));
  const Vector a = mesh.point(mesh.target(h)) - v, b = mesh.point(mesh.apex(h)) - v;
  return std::atan2(cross(a, b), dot(a, b));
}

/// Do any two edges on curves leave the star's vertex less than 60 degrees apart? Where one smooth curve passes, as
/// nearly everywhere, they leave in opposite directions, and nothing else needs to be asked. A single edge counts as
/// a pair with itself.
bool has_sharp_pair(const Mesh& mesh, const Star& star, std::vector<Vector>& directions) {
  directions.clear();
  for (const HalfEdgeId h : star.outgoing) {
    if (mesh.is_constrained(h)) directions.push_back(direction(mesh, h, false));
    const HalfEdgeId back = previous(h);  // the last edge of each half-disk has no half-edge that leaves
    if (mesh.twin(back) == none && mesh.is_constrained(back)) directions.push_back(direction(mesh, back, true));
  }
  if (directions.size() == 1) return true;
  for (std::size_t i = 1; i < directions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (is_below_sixty(directions[i], directions[j])) return true;
  return false;
}

/// The face in which two neighbouring edges on curves enclose a small angle at the star's vertex; `several` if there is
/// more than one such face, outside if there is none. The angle is that of the tangents; the logical triangles between
/// the two edges tell it from the rest of the full turn.
FaceId sharp_face(const Mesh& mesh, const Star& star) {
  const std::size_t n = star.outgoing.size();
  FaceId face = outside;
  for (std::size_t i = 0; i < n; ++i) {
    if (!mesh.is_constrained(star.outgoing[i])) continue;
    const Vector from = direction(mesh, star.outgoing[i], false);
    double angle = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const HalfEdgeId h = star.outgoing[(i + k) % n];
      angle += logical_angle(mesh, h);
      if (angle > std::numbers::pi) break;
      const HalfEdgeId closing = previous(h);
      if (!mesh.is_constrained(closing)) continue;
      const FaceId here = mesh.face(triangle_of(h));
      if (is_below_sixty(from, direction(mesh, closing, true))) face = face == outside || face == here ? here : several;
      break;
    }
  }
  return face;
}

/// Collects the vertices that constrained edges join to the star's vertex.
void curve_neighbors(const Mesh& mesh, const Star& star, std::vector<PointId>& out) {
  out.clear();
  for (const HalfEdgeId h : star.outgoing) {
    if (mesh.is_constrained(h)) out.push_back(mesh.target(h));
    // The last edge of each half-disk has no half-edge that leaves.
    const HalfEdgeId back = previous(h);
    if (mesh.is_constrained(back) && mesh.twin(back) == none) out.push_back(mesh.origin(back));
  }
}

double angle_between(const Vector& a, const Vector& b) { return std::atan2(std::fabs(cross(a, b)), dot(a, b)); }

}  // namespace

SharpCorners::SharpCorners(const Mesh& mesh) {
  find_corners(mesh);
  if (!corners_.empty()) find_sides(mesh);
}

void SharpCorners::find_corners(const Mesh& mesh) {
  Star star;
  std::vector<Vector> directions;
  std::vector<bool> is_seen(index(mesh.point_slots()), false);
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (!mesh.is_constrained(h) || !mesh.is_alive(triangle_of(h))) continue;
    // At a corner one constrained half-edge of each face leaves and one arrives; looking at those that leave is enough.
    const PointId v = mesh.origin(h);
    if (is_seen[index(v)]) continue;
    is_seen[index(v)] = true;
    find_star(mesh, v, star);
    if (!has_sharp_pair(mesh, star, directions)) continue;
    if (const FaceId f = sharp_face(mesh, star); f != outside) corners_.emplace(v, f);
  }
}

void SharpCorners::find_sides(const Mesh& mesh) {
  sides_of_.assign(index(mesh.point_slots()), none);
  std::vector<char> is_node(index(mesh.point_slots()), 0);
  std::vector<PointId> neighbors;
  Star star;
  std::vector<PointId> corners;
  for (const auto& [v, face] : corners_) corners.push_back(v);
  std::sort(corners.begin(), corners.end());
  for (const HalfEdgeId h : mesh.half_edges()) {
    if (!mesh.is_alive(triangle_of(h)) || !mesh.is_constrained(h)) continue;
    // A vertex is a node where other than two edges on curves meet. Edges are counted by the half-edges that leave, and
    // by those that arrive and have no twin.
    const auto count = [&](PointId v) { is_node[index(v)] = static_cast<char>(std::min(is_node[index(v)] + 1, 100)); };
    count(mesh.origin(h));
    if (mesh.twin(h) == none) count(mesh.target(h));
  }
  for (char& edges : is_node) edges = edges != 2;
  for (const PointId v : corners) is_node[index(v)] = 1;
  for (const PointId v : corners) {
    find_star(mesh, v, star);
    curve_neighbors(mesh, star, neighbors);
    for (const PointId w : std::vector<PointId>(neighbors)) follow(mesh, v, w, is_node);
  }
}

/// Walks from a corner along one of its edges to the next node, and makes a side of the vertices that it passes. Where
/// it comes back to the same corner it makes two sides, one of each half.
void SharpCorners::follow(const Mesh& mesh, PointId from, PointId to, const std::vector<char>& is_node) {
  if (!is_node[index(to)] && side_of(to) != none) return;  // walked from its other end
  if (is_node[index(to)] && one_edge_.count(key(from, to)) > 0) return;
  std::vector<PointId> passed, neighbors;
  Star star;
  PointId before = from, v = to;
  while (!is_node[index(v)]) {
    passed.push_back(v);
    find_star(mesh, v, star);
    curve_neighbors(mesh, star, neighbors);
    const PointId next = neighbors.front() == before ? neighbors.back() : neighbors.front();
    before = v;
    v = next;
  }
  const auto side = static_cast<SideId>(sides_.size());
  sides_.push_back({{from, contains(v) && v != from ? v : none}});
  ending_at_[from].push_back(side);
  if (v != from) ending_at_[v].push_back(side);
  if (passed.empty()) one_edge_[key(from, v)] = side;
  for (const PointId w : passed) sides_of_[index(w)] = side;
  if (v != from) return;
  sides_.push_back({{from, none}});
  for (std::size_t k = passed.size() / 2; k < passed.size(); ++k) sides_of_[index(passed[k])] = side + 1;
}

void SharpCorners::add_between(PointId v, PointId first, PointId last) {
  if (corners_.empty()) return;
  SideId side = side_of(first);
  if (side == none) side = side_of(last);
  if (side == none)
    if (const auto found = one_edge_.find(key(first, last)); found != one_edge_.end()) side = found->second;
  if (sides_of_.size() <= index(v)) sides_of_.resize(2 * index(v) + 1, none);
  sides_of_[index(v)] = side;
}

std::span<const SharpCorners::SideId> SharpCorners::all_sides_of(PointId v, SideId& storage) const {
  storage = side_of(v);
  if (storage != none) return {&storage, 1};
  const auto found = ending_at_.find(v);
  return found == ending_at_.end() ? std::span<const SideId>() : std::span<const SideId>(found->second);
}

PointId SharpCorners::shared(const Mesh& mesh, PointId p, PointId q, FaceId f) const {
  if (corners_.empty()) return none;
  SideId of_p = none, of_q = none;
  PointId best = none;
  double least = wide;
  for (const SideId a : all_sides_of(p, of_p))
    for (const SideId b : all_sides_of(q, of_q)) {
      if (a == b) continue;
      for (const PointId corner : sides_[index(a)].corners) {
        const auto& others = sides_[index(b)].corners;
        if (corner == none || corner == p || corner == q) continue;
        if (std::find(others.begin(), others.end(), corner) == others.end()) continue;
        const FaceId face = corners_.at(corner);
        if (face != f && face != several) continue;
        const Point& apex = mesh.point(corner);
        const double angle = angle_between(mesh.point(p) - apex, mesh.point(q) - apex);
        if (angle < least) least = angle, best = corner;
      }
    }
  return best;
}

PointId SharpCorners::narrow_wedge(const Mesh& mesh, PointId p, PointId q, FaceId f) const {
  const PointId corner = shared(mesh, p, q, f);
  if (corner == none) return none;
  const Point& apex = mesh.point(corner);
  return angle_between(mesh.point(p) - apex, mesh.point(q) - apex) < narrow ? corner : none;
}

bool SharpCorners::excuses(const Mesh& mesh, HalfEdgeId shortest, double longest) const {
  const PointId p = mesh.origin(shortest), q = mesh.target(shortest);
  if (mesh.is_constrained(shortest)) return false;  // joins the two halves of a side that comes back to its corner
  const PointId corner = shared(mesh, p, q, mesh.face(triangle_of(shortest)));
  if (corner == none) return false;
  const Point& apex = mesh.point(corner);
  const auto [near, far] = std::minmax({distance(apex, mesh.point(p)), distance(apex, mesh.point(q))});
  const double third = distance(apex, mesh.point(mesh.apex(shortest)));
  // A triangle beyond the end of one of the two sides lies outside the wedge.
  if (third > far && (side_of(p) == none || side_of(q) == none)) return false;
  if (far <= most_ratio * near && angle_between(mesh.point(p) - apex, mesh.point(q) - apex) < narrow) return true;
  return far < same_distance * near && std::min(near, third) <= corner_reach * longest && longest <= most_extent * near;
}

SharpCorners::Mirror SharpCorners::mirror(const Mesh& mesh, HalfEdgeId h) const {
  if (corners_.empty()) return {};
  const PointId a = mesh.origin(h), b = mesh.target(h);
  Mirror found;
  double nearest = HUGE_VAL;
  for (const HalfEdgeId side : {h, mesh.twin(h)}) {
    if (side == none) continue;
    const PointId v = mesh.apex(side);
    for (const PointId end : {a, b}) {
      const PointId corner = shared(mesh, v, end, mesh.face(triangle_of(side)));
      if (corner == none ||
          angle_between(mesh.point(v) - mesh.point(corner), mesh.point(end) - mesh.point(corner)) > 0.5)
        continue;
      const double off = distance(mesh.point(v), 0.5 * (mesh.point(a) + mesh.point(b)));
      if (off < nearest) nearest = off, found = {corner, distance(mesh.point(corner), mesh.point(v))};
    }
  }
  return found;
}

}  // namespace pliant
