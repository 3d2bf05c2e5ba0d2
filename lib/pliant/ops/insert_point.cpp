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

constexpr double outside_by = 1e-9;  // barycentric: what locating rounds

constexpr Barycentric unit(int corner) {
  return {corner == 0 ? 1.0 : 0.0, corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0};
}

/// Writes the child's rows to the points of triangle t that are in none of the edges to be left alone.
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
  if (!all_valid(mesh, children)) return {Refusal::would_invert, none};
  transaction.commit();
  return {Refusal::done, v};
}

}  // namespace

InsertResult insert_point(Mesh& mesh, TriangleId t, const Barycentric& xi, double edge_tolerance) {
  const auto least = std::min_element(xi.begin(), xi.end());
  if (!(xi[0] + xi[1] + xi[2] < 2) || *least < -edge_tolerance - outside_by) return {Refusal::not_in_domain, none};
  if (*least >= edge_tolerance) return insert_inside(mesh, t, xi);
  const int corner = static_cast<int>(least - xi.begin());
  const int edge = (corner + 1) % 3;  // opposite
  const double from = xi[static_cast<std::size_t>(edge)], to = xi[static_cast<std::size_t>((edge + 1) % 3)];
  const double s = to / (from + to);
  if (!(s > edge_tolerance && s < 1 - edge_tolerance)) return {Refusal::edge_exists, none};  // the point is a vertex
  return split_edge(mesh, half_edge(t, edge), s);
}

InsertResult split_edge(Mesh& mesh, HalfEdgeId h, double s) {
  if (!(s > 0 && s < 1)) return {Refusal::not_in_domain, none};
  const ConstraintId constraint = mesh.constraint(h);
  Transaction transaction(mesh);
  const int p = mesh.degree();
  const PointId a = mesh.origin(h), b = mesh.target(h);
  const HalfEdgeId opposite = mesh.twin(h);
  const EdgePoints old = side_of(mesh, h).points;
  const PointId x = mesh.add_point();
  const EdgePoints first = new_edge(a, x, {old.ids.data() + 1, static_cast<std::size_t>(p - 1)}, p);
  const EdgePoints second = new_edge(mesh, x, b);
  scratch(0).take(mesh, triangle_of(h));
  if (opposite != none) scratch(1).take(mesh, triangle_of(opposite));  // before the shared points are overwritten

  std::array<TriangleId, 4> touched{none, none, none, none};
  std::array<HalfEdgeId, 2> first_half{none, none}, second_half{none, none};  // a-x and x-b, on either side
  for (int side = 0; side < 2; ++side) {
    const HalfEdgeId g = side == 0 ? h : opposite;
    if (g == none) continue;
    const TriangleId t = triangle_of(g);
    const FaceId f = mesh.face(t);
    const int e = edge_of(g);
    Pieces& pieces = scratch(side);
    const Side ahead = side_of(mesh, next(g)), behind = side_of(mesh, previous(g));
    const PointId apex = mesh.apex(g);
    const EdgePoints spoke = new_edge(mesh, x, apex);
    const EdgePoints near = side == 0 ? first : second.reversed();  // origin(g) to x
    const EdgePoints far = side == 0 ? second : first.reversed();   // x to target(g)
    const TriangleId u = mesh.add_triangle(f);
    const InnerPoints inner = inner_points(mesh, t), inner_new = new_inner_points(mesh);
    // Both pieces have the split edge as local edge e: t keeps origin(g), u gets target(g).
    build_triangle(mesh, t, near, spoke, behind.points, inner, e);
    build_triangle(mesh, u, far, ahead.points, spoke.reversed(), inner_new, e);
    attach(mesh, previous(g), behind);
    attach(mesh, half_edge(u, (e + 1) % 3), ahead);
    mesh.link(next(g), half_edge(u, (e + 2) % 3));
    mesh.set_constraint(next(g), none);
    Barycentric on_edge{};
    const double along = side == 0 ? s : 1 - s;
    on_edge[static_cast<std::size_t>(e)] = 1 - along;
    on_edge[static_cast<std::size_t>((e + 1) % 3)] = along;
    std::array<Barycentric, 3> corners{unit(0), unit(1), unit(2)};
    corners[static_cast<std::size_t>((e + 1) % 3)] = on_edge;
    pieces.cut(corners[0], corners[1], corners[2]);
    mesh.put_row(x, f, pieces.row((e + 1) % 3));
    put_edge_rows(mesh, t, e, f, pieces);
    put_edge_rows(mesh, t, (e + 1) % 3, f, pieces);
    put_inner_rows(mesh, t, f, pieces);
    corners = {unit(0), unit(1), unit(2)};
    corners[static_cast<std::size_t>(e)] = on_edge;
    pieces.cut(corners[0], corners[1], corners[2]);
    put_edge_rows(mesh, u, e, f, pieces);
    put_inner_rows(mesh, u, f, pieces);
    touched[static_cast<std::size_t>(2 * side)] = t;
    touched[static_cast<std::size_t>(2 * side + 1)] = u;
    first_half[static_cast<std::size_t>(side)] = side == 0 ? g : half_edge(u, e);
    second_half[static_cast<std::size_t>(side)] = side == 0 ? half_edge(u, e) : g;
  }
  mesh.link(first_half[0], first_half[1]);
  mesh.link(second_half[0], second_half[1]);

  if (constraint != none) {
    const CurveId curve = mesh.constraint_curve(constraint);
    const bool forward = mesh.constraint_first(constraint) == a;
    const double t0 = mesh.constraint_start(constraint), t1 = mesh.spline(curve).span_end(t0);
    const double t = t0 + (forward ? s : 1 - s) * (t1 - t0);
    if (!(t0 < t && t < t1)) return {Refusal::would_invert, none};
    mesh.insert_knot(curve, t);
    const ConstraintId added = mesh.add_constraint(curve, t, x);
    const auto mark = [&mesh](const std::array<HalfEdgeId, 2>& half, ConstraintId c) {
      for (const HalfEdgeId g : half)
        if (g != none) mesh.set_constraint(g, c);
    };
    mark(forward ? first_half : second_half, constraint);
    mark(forward ? second_half : first_half, added);
    // The mesh takes the curve's own extraction, so that M4 holds to the last bits however often edges are split.
    const BSpline& spline = mesh.spline(curve);
    std::array<Point, max_degree + 1> bezier;
    for (const double start : {t0, t}) {
      spline.extract(start, {bezier.data(), static_cast<std::size_t>(p + 1)});
      const EdgePoints& half = (start == t0) == forward ? first : second;
      for (int k = 1; k < p; ++k) mesh.set_point(half[forward ? k : p - k], bezier[static_cast<std::size_t>(k)]);
      if (start == t) mesh.set_point(x, bezier[0]);
    }
  } else {
    for (const HalfEdgeId g : {first_half[0], first_half[1], second_half[0], second_half[1]})
      if (g != none) mesh.set_constraint(g, none);
  }
  for (const TriangleId t : touched)
    if (t != none && !is_valid(mesh, t)) return {Refusal::would_invert, none};
  transaction.commit();
  return {Refusal::done, x};
}

}  // namespace pliant
