// lib/pliant/ops/remove_point.cpp: removal of inner vertices: four triangles to two, or ears and then three to one.
#include "pliant/ops/remove_point.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/refit/refit.h"
#include "pliant/ops/removal/merge.h"
#include "pliant/ops/removal/recover_parent.h"

namespace pliant {
namespace {

void put_rows(Mesh& mesh, TriangleId t, std::span<const double> rows, int first, int last) {
  const auto width = index(mesh.width());
  for (int k = first; k < last; ++k)
    mesh.put_row(mesh.net(t)[index(k)], mesh.face(t), rows.subspan(index(k) * width, width));
}

/// Finds the parent of the three triangles of a star, if they are its subdivision. Its corners are in the star's order.
bool recover_of_three(const Mesh& mesh, const Star& star, ParentRecovery& parent) {
  const int p = mesh.degree();
  const NetLayout& layout = mesh.layout();
  std::array<TriangleId, 3> old;
  for (int c = 0; c < 3; ++c) old[index(c)] = triangle_of(star.outgoing[index(c)]);
  parent.start(mesh, old);
  for (int c = 0; c < 3; ++c) parent.take_edge(c, c, edge_of(next(star.outgoing[index(c)])));
  // Where is v in the parent? On the edge from each corner to v, the control point next to the corner comes from the
  // first step of de Casteljau there: corner + xi2 (along 12) + xi3 (along 13) at the first corner, and so on. These
  // are six equations for xi2 and xi3, solved by least squares.
  double aa = 0, ab = 0, bb = 0, ar = 0, br = 0;
  for (int c = 0; c < 3; ++c) {
    // The blossom with all arguments but the last at this corner, and the last one at each of the three corners.
    std::array<Point, 3> last;
    last[index(c)] = parent.point(c);
    last[index((c + 1) % 3)] = parent.point(layout.edge_index(c, 1));
    last[index((c + 2) % 3)] = parent.point(layout.edge_index((c + 2) % 3, p - 1));
    const Vector a = last[1] - last[0], b = last[2] - last[0];
    const Vector r = mesh.point(mesh.edge_point(star.outgoing[index(c)], p - 1)) - last[0];
    aa += dot(a, a), ab += dot(a, b), bb += dot(b, b), ar += dot(a, r), br += dot(b, r);
  }
  const double det = aa * bb - ab * ab;
  if (!(det > 0)) return false;
  const double xi2 = (bb * ar - ab * br) / det, xi3 = (aa * br - ab * ar) / det;
  const Barycentric v{1 - xi2 - xi3, xi2, xi3};
  if (!(v[0] > 0 && v[1] > 0 && v[2] > 0)) return false;
  std::array<std::array<Barycentric, 3>, 3> corners;
  for (int c = 0; c < 3; ++c) {
    Barycentric from{}, to{};
    from[index(c)] = 1;
    to[index((c + 1) % 3)] = 1;
    const int e = edge_of(star.outgoing[index(c)]);
    corners[index(c)][index(e)] = v;
    corners[index(c)][index((e + 1) % 3)] = from;
    corners[index(c)][index((e + 2) % 3)] = to;
  }
  return parent.find_inner(corners);
}

/// Undoes a split (4→2) if the four triangles are the pieces of two, divided on the edge from link vertex `first` to
/// link vertex first + 2: the two parents come back.
bool undo_split(Mesh& mesh, PointId v, const Star& star, int first) {
  const auto link = [&](int i) { return mesh.target(star.outgoing[index((first + i) % 4)]); };
  const std::array<PointId, 3> right{link(0), link(1), link(2)}, left{link(2), link(3), link(0)};
  if (are_joined(mesh, link(0), link(2))) return false;
  const int p = mesh.degree();
  thread_local std::array<ParentRecovery, 2> parents;
  if (!recover_merged(mesh, v, right, parents[0])) return false;
  std::array<Point, max_degree + 1> shared;  // as the left parent has it; in the right one it runs the other way
  for (int k = 0; k <= p; ++k) shared[index(k)] = parents[0].point(mesh.layout().edge_index(2, p - k));
  if (!recover_merged(mesh, v, left, parents[1], {shared.data(), index(p + 1)})) return false;
  Transaction transaction(mesh);
  const EdgePoints half = side_of(mesh, star.outgoing[index(first)]).points;  // v to link 0
  const EdgePoints other = side_of(mesh, star.outgoing[index((first + 2) % 4)]).points;
  const EdgePoints edge = new_edge(link(2), link(0), {half.ids.data() + 1, index(p - 1)}, p);
  const HalfEdgeId right_start = star.outgoing[index(first)], left_start = star.outgoing[index((first + 2) % 4)];
  const TriangleId t = merge_fan(mesh, right_start, edge), u = merge_fan(mesh, left_start, edge.reversed());
  mesh.link(half_edge(t, 2), half_edge(u, 2));
  free_edge_points(mesh, other);
  mesh.free_point(v);
  put_rows(mesh, t, parents[0].rows(), 3 + 2 * (p - 1), mesh.net_size());  // the edge's points, then the inner ones
  put_rows(mesh, u, parents[1].rows(), mesh.layout().first_interior(), mesh.net_size());
  if (!is_valid(mesh, t) || !is_valid(mesh, u)) return false;
  transaction.commit();
  return true;
}

}  // namespace

Outcome remove_degree_three(Mesh& mesh, PointId v, const RefitOptions& options) {
  thread_local Star star;
  find_star(mesh, v, star);
  if (is_on_curve(mesh, star)) return Outcome::constrained;
  if (star.degree() != 3) return Outcome::not_removable;
  Transaction transaction(mesh);
  thread_local ParentRecovery parent;
  const bool is_subdivision = recover_of_three(mesh, star, parent);
  std::array<TriangleId, 3> old;
  std::array<Side, 3> sides;
  for (int c = 0; c < 3; ++c) {
    old[index(c)] = triangle_of(star.outgoing[index(c)]);
    sides[index(c)] = side_of(mesh, next(star.outgoing[index(c)]));
  }
  thread_local Patch patch;
  if (!is_subdivision) patch.capture(mesh, old);
  for (const HalfEdgeId h : star.outgoing) free_edge_points(mesh, side_of(mesh, h).points);
  const TriangleId t = old[0];
  const InnerPoints inner = inner_points(mesh, t);
  for (const TriangleId dropped : {old[1], old[2]}) {
    free_inner_points(mesh, inner_points(mesh, dropped));
    mesh.free_triangle(dropped);
  }
  mesh.free_point(v);
  build_triangle(mesh, t, sides[0].points, sides[1].points, sides[2].points, inner);
  for (int c = 0; c < 3; ++c) attach(mesh, half_edge(t, c), sides[index(c)]);
  const std::array<TriangleId, 1> now{t};
  if (is_subdivision) {
    put_rows(mesh, t, parent.rows(), mesh.layout().first_interior(), mesh.net_size());
    if (!is_valid(mesh, t)) return Outcome::would_invert;
  } else {
    const std::span<const PointId> free{inner.data(), index(interior_size(mesh.degree()))};
    if (!patch.fit_geometry(mesh, now, free)) return Outcome::would_invert;
    if (!patch.fit_fields(mesh, now, free, options)) return Outcome::loses_integral;
  }
  transaction.commit();
  return Outcome::done;
}

Outcome remove_inner_vertex(Mesh& mesh, PointId v, const RefitOptions& options) {
  thread_local Star star;
  find_star(mesh, v, star);
  if (is_on_curve(mesh, star)) return Outcome::constrained;
  if (star.degree() == 4)
    for (const int first : {0, 1})
      if (undo_split(mesh, v, star, first)) return Outcome::done;
  Transaction transaction(mesh);
  thread_local Fan fan;
  fan.clear();
  for (const HalfEdgeId h : star.outgoing) fan.push_back(mesh.target(h));
  if (!reduce_fan(mesh, v, fan, true, 3, options)) return Outcome::not_removable;
  const Outcome outcome = remove_degree_three(mesh, v, options);
  if (outcome == Outcome::done) transaction.commit();
  return outcome;
}

}  // namespace pliant
