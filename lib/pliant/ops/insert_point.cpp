// lib/pliant/ops/insert_point.cpp: triangles cut in three, edges and the curves under them cut in two.
#include "pliant/ops/insert_point.h"

#include <algorithm>
#include <array>
#include <vector>

#include "pliant/geometry/control_net.h"
#include "pliant/ops/build_triangle.h"

namespace pliant {
namespace {

/// Rows of one triangle and of the pieces it is cut into; memory is reused from call to call.
struct Pieces {
  std::vector<double> parent, child;
  int degree = 0, width = 0;

  void take(const Mesh& mesh, TriangleId t) {
    degree = mesh.degree();
    width = mesh.width();
    parent.resize(static_cast<std::size_t>(mesh.net_size() * width));
    child.resize(parent.size());
    mesh.gather(t, parent);
  }
  void cut(const Barycentric& a, const Barycentric& b, const Barycentric& c) {
    sub_net(degree, width, parent, a, b, c, child);
  }
  std::span<const double> row(int index) const {
    return std::span<const double>(child).subspan(static_cast<std::size_t>(index * width),
                                                  static_cast<std::size_t>(width));
  }
};

Pieces& scratch(int which = 0) {
  thread_local std::array<Pieces, 2> pieces;
  return pieces[static_cast<std::size_t>(which)];
}

constexpr double outside_by = 1e-9;  // so far outside a barycentric coordinate may be: what locating rounds

constexpr Barycentric unit(int corner) {
  return {corner == 0 ? 1.0 : 0.0, corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0};
}

/// Writes the child's rows to the inner points of triangle t.
void put_inner_rows(Mesh& mesh, TriangleId t, FaceId f, const Pieces& pieces) {
  const auto net = mesh.net(t);
  for (int k = mesh.layout().first_interior(); k < mesh.net_size(); ++k)
    mesh.put_row(net[static_cast<std::size_t>(k)], f, pieces.row(k));
}

void put_edge_rows(Mesh& mesh, TriangleId t, int edge, FaceId f, const Pieces& pieces) {
  const NetLayout& layout = mesh.layout();
  for (int k = 1; k < mesh.degree(); ++k) {
    const int index = layout.edge_index(edge, k);
    mesh.put_row(mesh.net(t)[static_cast<std::size_t>(index)], f, pieces.row(index));
  }
}

InsertResult insert_inside(Mesh& mesh, TriangleId t, const Barycentric& xi) {
  Transaction transaction(mesh);
  const FaceId f = mesh.face(t);
  Pieces& pieces = scratch();
  pieces.take(mesh, t);
  const std::array<Side, 3> sides{side_of(mesh, half_edge(t, 0)), side_of(mesh, half_edge(t, 1)),
                                  side_of(mesh, half_edge(t, 2))};
  const PointId v = mesh.add_point();
  std::array<EdgePoints, 3> spokes;  // from the corners to v
  for (int c = 0; c < 3; ++c)
    spokes[static_cast<std::size_t>(c)] = new_edge(mesh, sides[static_cast<std::size_t>(c)].points.front(), v);
  const std::array<TriangleId, 3> children{t, mesh.add_triangle(f), mesh.add_triangle(f)};
  const std::array<InnerPoints, 3> inner{inner_points(mesh, t), new_inner_points(mesh), new_inner_points(mesh)};
  for (int c = 0; c < 3; ++c) {
    const auto k = static_cast<std::size_t>(c), k_next = static_cast<std::size_t>((c + 1) % 3);
    build_triangle(mesh, children[k], sides[k].points, spokes[k_next], spokes[k].reversed(), inner[k]);
  }
  for (int c = 0; c < 3; ++c) {
    const auto k = static_cast<std::size_t>(c), k_next = static_cast<std::size_t>((c + 1) % 3);
    attach(mesh, half_edge(children[k], 0), sides[k]);
    mesh.link(half_edge(children[k], 1), half_edge(children[k_next], 2));
    mesh.set_constraint(half_edge(children[k], 1), none);
    mesh.set_constraint(half_edge(children[k], 2), none);
    pieces.cut(unit(c), unit((c + 1) % 3), xi);
    if (c == 0) mesh.put_row(v, f, pieces.row(2));
    put_edge_rows(mesh, children[k], 2, f, pieces);
    put_inner_rows(mesh, children[k], f, pieces);
  }
  mesh.set_vertex_half_edge(v, half_edge(t, 2));
  if (!all_valid(mesh, children)) return {Outcome::would_invert, none};
  transaction.commit();
  return {Outcome::done, v};
}

/// The split of an edge from a to b at a new vertex x, with the triangles on its sides and the curve that it lies on.
class EdgeSplit {
 public:
  /// Makes x and the edges a-x and x-b, and copies what the sides hold.
  EdgeSplit(Mesh& mesh, HalfEdgeId h, double s, SplitCheck check);
  PointId vertex() const { return x_; }
  /// Replaces the triangle on each side by two that subdivide it.
  void split_sides();
  /// Inserts the knot, if the edge lies on a curve. False if there is no double between the ends of the span.
  bool split_curve();
  bool is_valid() const;

 private:
  void split_side(int side);
  /// Writes the rows of both pieces of a side: t has the origin of the side's half-edge, u its target; in both, half of
  /// the split edge is local edge e.
  void put_rows(int side, TriangleId t, TriangleId u, int e);
  void constrain(const std::array<HalfEdgeId, 2>& half, ConstraintId constraint);
  /// Places the points of both edges where the curve's Bézier form has them, so that M4 holds to the last bits however
  /// often edges are split. The two spans start at t0 and t.
  void place_on_curve(const BSpline& spline, double t0, double t, bool forward);

  Mesh& mesh_;
  double s_;
  PointId a_, x_;
  std::array<HalfEdgeId, 2> sides_;  // the half-edges from a and from b; the second may be none
  ConstraintId constraint_;
  EdgePoints first_, second_;                                                   // a-x and x-b
  std::array<HalfEdgeId, 2> first_half_{none, none}, second_half_{none, none};  // their half-edges on either side
  std::array<TriangleId, 4> touched_{none, none, none, none};                   // the pieces: two for each side
  std::array<bool, 2> may_be_invalid_{};  // for each side: its pieces need not be valid
};

EdgeSplit::EdgeSplit(Mesh& mesh, HalfEdgeId h, double s, SplitCheck check)
    : mesh_(mesh), s_(s), a_(mesh.origin(h)), sides_{h, mesh.twin(h)}, constraint_(mesh.constraint(h)) {
  const PointId b = mesh.target(h);
  const EdgePoints old = side_of(mesh, h).points;
  x_ = mesh.add_point();
  first_ = new_edge(a_, x_, {old.ids.data() + 1, static_cast<std::size_t>(mesh.degree() - 1)}, mesh.degree());
  second_ = new_edge(mesh, x_, b);
  for (int side = 0; side < 2; ++side) {  // both sides are read before their shared points are overwritten
    const HalfEdgeId g = sides_[static_cast<std::size_t>(side)];
    if (g == none) continue;
    scratch(side).take(mesh, triangle_of(g));
    may_be_invalid_[static_cast<std::size_t>(side)] =
        check == SplitCheck::stays_valid && !pliant::is_valid(mesh, triangle_of(g));
  }
}

void EdgeSplit::split_sides() {
  for (int side = 0; side < 2; ++side)
    if (sides_[static_cast<std::size_t>(side)] != none) split_side(side);
  mesh_.link(first_half_[0], first_half_[1]);
  mesh_.link(second_half_[0], second_half_[1]);
}

void EdgeSplit::split_side(int side) {
  const auto k = static_cast<std::size_t>(side);
  const HalfEdgeId g = sides_[k];
  const TriangleId t = triangle_of(g);
  const int e = edge_of(g);
  const Side ahead = side_of(mesh_, next(g)), behind = side_of(mesh_, previous(g));
  const PointId apex = mesh_.apex(g);
  const EdgePoints spoke = new_edge(mesh_, x_, apex);
  const EdgePoints near = side == 0 ? first_ : second_.reversed();  // origin(g) to x
  const EdgePoints far = side == 0 ? second_ : first_.reversed();   // x to target(g)
  const TriangleId u = mesh_.add_triangle(mesh_.face(t));
  const InnerPoints inner = inner_points(mesh_, t), inner_new = new_inner_points(mesh_);
  // Both pieces have the split edge as local edge e: t keeps origin(g), u gets target(g).
  build_triangle(mesh_, t, near, spoke, behind.points, inner, e);
  build_triangle(mesh_, u, far, ahead.points, spoke.reversed(), inner_new, e);
  attach(mesh_, previous(g), behind);
  attach(mesh_, half_edge(u, (e + 1) % 3), ahead);
  mesh_.link(next(g), half_edge(u, (e + 2) % 3));
  mesh_.set_constraint(next(g), none);
  put_rows(side, t, u, e);
  touched_[2 * k] = t;
  touched_[2 * k + 1] = u;
  first_half_[k] = side == 0 ? g : half_edge(u, e);
  second_half_[k] = side == 0 ? half_edge(u, e) : g;
}

void EdgeSplit::put_rows(int side, TriangleId t, TriangleId u, int e) {
  const FaceId f = mesh_.face(t);
  const int e_next = (e + 1) % 3;
  Pieces& pieces = scratch(side);
  Barycentric on_edge{};
  const double along = side == 0 ? s_ : 1 - s_;
  on_edge[static_cast<std::size_t>(e)] = 1 - along;
  on_edge[static_cast<std::size_t>(e_next)] = along;
  std::array<Barycentric, 3> corners{unit(0), unit(1), unit(2)};
  corners[static_cast<std::size_t>(e_next)] = on_edge;
  pieces.cut(corners[0], corners[1], corners[2]);
  mesh_.put_row(x_, f, pieces.row(e_next));
  put_edge_rows(mesh_, t, e, f, pieces);
  put_edge_rows(mesh_, t, e_next, f, pieces);
  put_inner_rows(mesh_, t, f, pieces);
  corners = {unit(0), unit(1), unit(2)};
  corners[static_cast<std::size_t>(e)] = on_edge;
  pieces.cut(corners[0], corners[1], corners[2]);
  put_edge_rows(mesh_, u, e, f, pieces);
  put_inner_rows(mesh_, u, f, pieces);
}

void EdgeSplit::constrain(const std::array<HalfEdgeId, 2>& half, ConstraintId constraint) {
  for (const HalfEdgeId g : half)
    if (g != none) mesh_.set_constraint(g, constraint);
}

bool EdgeSplit::split_curve() {
  if (constraint_ == none) {
    constrain(first_half_, none);
    constrain(second_half_, none);
    return true;
  }
  const CurveId curve = mesh_.constraint_curve(constraint_);
  const bool forward = mesh_.constraint_first(constraint_) == a_;
  const double t0 = mesh_.constraint_start(constraint_), t1 = mesh_.spline(curve).span_end(t0);
  const double t = t0 + (forward ? s_ : 1 - s_) * (t1 - t0);
  if (!(t0 < t && t < t1)) return false;
  mesh_.insert_knot(curve, t);
  const ConstraintId added = mesh_.add_constraint(curve, t, x_);
  constrain(forward ? first_half_ : second_half_, constraint_);
  constrain(forward ? second_half_ : first_half_, added);
  place_on_curve(mesh_.spline(curve), t0, t, forward);
  return true;
}

void EdgeSplit::place_on_curve(const BSpline& spline, double t0, double t, bool forward) {
  const int p = mesh_.degree();
  std::array<Point, max_degree + 1> bezier;
  for (const double start : {t0, t}) {
    spline.extract(start, {bezier.data(), static_cast<std::size_t>(p + 1)});
    const EdgePoints& half = (start == t0) == forward ? first_ : second_;
    for (int k = 1; k < p; ++k) mesh_.set_point(half[forward ? k : p - k], bezier[static_cast<std::size_t>(k)]);
    if (start == t) mesh_.set_point(x_, bezier[0]);
  }
}

bool EdgeSplit::is_valid() const {
  for (std::size_t k = 0; k < touched_.size(); ++k)
    if (touched_[k] != none && !may_be_invalid_[k / 2] && !pliant::is_valid(mesh_, touched_[k])) return false;
  return true;
}

}  // namespace

InsertResult insert_point(Mesh& mesh, TriangleId t, const Barycentric& xi, double edge_tolerance) {
  const auto least = std::min_element(xi.begin(), xi.end());
  if (!(xi[0] + xi[1] + xi[2] < 2) || *least < -edge_tolerance - outside_by) return {Outcome::not_in_domain, none};
  if (*least >= edge_tolerance) return insert_inside(mesh, t, xi);
  const int corner = static_cast<int>(least - xi.begin());
  const int edge = (corner + 1) % 3;  // opposite
  const double from = xi[static_cast<std::size_t>(edge)], to = xi[static_cast<std::size_t>((edge + 1) % 3)];
  const double s = to / (from + to);
  if (!(s > edge_tolerance && s < 1 - edge_tolerance)) return {Outcome::edge_exists, none};  // the point is a vertex
  return split_edge(mesh, half_edge(t, edge), s);
}

InsertResult split_edge(Mesh& mesh, HalfEdgeId h, double s, SplitCheck check) {
  if (!(s > 0 && s < 1)) return {Outcome::not_in_domain, none};
  Transaction transaction(mesh);
  EdgeSplit split(mesh, h, s, check);
  split.split_sides();
  if (!split.split_curve() || !split.is_valid()) return {Outcome::would_invert, none};
  transaction.commit();
  return {Outcome::done, split.vertex()};
}

}  // namespace pliant
