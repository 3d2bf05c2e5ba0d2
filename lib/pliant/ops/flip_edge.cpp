// lib/pliant/ops/flip_edge.cpp: checks the quadrilateral, then replaces its diagonal (paper §5.2.3).
#include "pliant/ops/flip_edge.h"

#include <array>
#include <utility>

#include "pliant/geometry/predicates.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/build_triangle.h"
#include "pliant/ops/refit/refit.h"

namespace pliant {
namespace {

/// A corner that turns by no more than this counts as straight: a curve goes on smoothly there, but for rounding. An
/// element there could be valid by rounding alone, and a place for its points would be searched for a long time.
constexpr double least_turn = 1e-10;

/// True if the tangents of two sides turn left where `into` ends and `out` starts, so that det J > 0 is possible there.
bool turns_left(const Mesh& mesh, const EdgePoints& into, const EdgePoints& out) {
  const int p = mesh.degree();
  const Point &before = mesh.point(into[p - 1]), &corner = mesh.point(into[p]), &after = mesh.point(out[1]);
  if (orient2d(before, corner, after) <= 0) return false;
  const Vector u = corner - before, v = after - corner;
  return dot(u, v) <= 0 || cross(u, v) > least_turn * dot(u, v);
}

}  // namespace

Outcome flip_edge(Mesh& mesh, HalfEdgeId h, const RefitOptions& options) {
  HalfEdgeId g = mesh.twin(h);
  if (g == none) return Outcome::outer_boundary;
  if (g < h) std::swap(g, h);  // the result must not depend on which of the two half-edges was named
  if (mesh.is_constrained(h)) return Outcome::constrained;
  const TriangleId t = triangle_of(h), u = triangle_of(g);
  const PointId a = mesh.origin(h), b = mesh.target(h), c = mesh.apex(h), d = mesh.apex(g);
  const Point &pa = mesh.point(a), &pb = mesh.point(b), &pc = mesh.point(c), &pd = mesh.point(d);
  // One of the two old logical triangles may be inverted: the flip mends that.
  if (orient2d(pa, pd, pc) <= 0 || orient2d(pd, pb, pc) <= 0 ||
      (orient2d(pa, pb, pc) <= 0 && orient2d(pb, pa, pd) <= 0))
    return Outcome::not_convex;
  if (c == d || are_joined(mesh, c, d)) return Outcome::edge_exists;

  const Side bc = side_of(mesh, next(h)), ca = side_of(mesh, previous(h));
  const Side ad = side_of(mesh, next(g)), db = side_of(mesh, previous(g));
  for (const auto& [into, out] : {std::pair(&ca, &ad), std::pair(&db, &bc)})
    if (!turns_left(mesh, into->points, out->points))
      return into->constraint != none && out->constraint != none ? Outcome::covers_corner : Outcome::bent_side;

  Transaction transaction(mesh);
  thread_local Patch patch;
  const std::array<TriangleId, 2> pair{t, u};
  patch.capture(mesh, pair);
  const EdgePoints old = side_of(mesh, h).points;
  const InnerPoints inner_t = inner_points(mesh, t), inner_u = inner_points(mesh, u);
  const int p = mesh.degree(), e = edge_of(h), f = edge_of(g);
  const EdgePoints dc = new_edge(d, c, {old.ids.data() + 1, static_cast<std::size_t>(p - 1)}, p);
  build_triangle(mesh, t, dc, ca.points, ad.points, inner_t, e);
  build_triangle(mesh, u, dc.reversed(), db.points, bc.points, inner_u, f);
  attach(mesh, half_edge(t, (e + 1) % 3), ca);
  attach(mesh, half_edge(t, (e + 2) % 3), ad);
  attach(mesh, half_edge(u, (f + 1) % 3), db);
  attach(mesh, half_edge(u, (f + 2) % 3), bc);

  std::array<PointId, (max_degree - 1) * (max_degree - 1)> free;
  std::size_t count = 0;
  for (int k = 1; k < p; ++k) free[count++] = dc[k];
  for (int k = 0; k < interior_size(p); ++k) {
    free[count++] = inner_t[static_cast<std::size_t>(k)];
    free[count++] = inner_u[static_cast<std::size_t>(k)];
  }
  if (!patch.fit_geometry(mesh, pair, {free.data(), count}, options.straight_below)) return Outcome::would_invert;
  if (!patch.fit_fields(mesh, pair, {free.data(), count}, options)) return Outcome::loses_integral;
  transaction.commit();
  return Outcome::done;
}

}  // namespace pliant
