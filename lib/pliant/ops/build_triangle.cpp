// lib/pliant/ops/build_triangle.cpp: reads, makes and frees edges and inner points, and writes nets from them.
#include "pliant/ops/build_triangle.h"

#include <algorithm>

#include "pliant/mesh/check_mesh.h"

namespace pliant {

EdgePoints EdgePoints::reversed() const {
  EdgePoints out = *this;
  std::reverse(out.ids.begin(), out.ids.begin() + degree + 1);
  return out;
}

Side side_of(const Mesh& mesh, HalfEdgeId h) {
  Side side;
  side.points.degree = mesh.degree();
  for (int k = 0; k <= mesh.degree(); ++k) side.points[k] = mesh.edge_point(h, k);
  side.twin = mesh.twin(h);
  side.constraint = mesh.constraint(h);
  return side;
}

EdgePoints new_edge(Mesh& mesh, PointId a, PointId b) {
  EdgePoints edge;
  edge.degree = mesh.degree();
  edge[0] = a;
  for (int k = 1; k < edge.degree; ++k) edge[k] = mesh.add_point();
  edge[edge.degree] = b;
  return edge;
}

EdgePoints new_edge(PointId a, PointId b, std::span<const PointId> reused, int degree) {
  EdgePoints edge;
  edge.degree = degree;
  edge[0] = a;
  for (int k = 1; k < degree; ++k) edge[k] = reused[static_cast<std::size_t>(k - 1)];
  edge[degree] = b;
  return edge;
}

InnerPoints inner_points(const Mesh& mesh, TriangleId t) {
  InnerPoints inner{};
  const auto net = mesh.net(t);
  const int first = mesh.layout().first_interior();
  for (int k = first; k < mesh.net_size(); ++k)
    inner[static_cast<std::size_t>(k - first)] = net[static_cast<std::size_t>(k)];
  return inner;
}

InnerPoints new_inner_points(Mesh& mesh) {
  InnerPoints inner{};
  for (int k = 0; k < interior_size(mesh.degree()); ++k) inner[static_cast<std::size_t>(k)] = mesh.add_point();
  return inner;
}

void free_inner_points(Mesh& mesh, const InnerPoints& inner) {
  for (int k = 0; k < interior_size(mesh.degree()); ++k) mesh.free_point(inner[static_cast<std::size_t>(k)]);
}

void free_edge_points(Mesh& mesh, const EdgePoints& edge) {
  for (int k = 1; k < edge.degree; ++k) mesh.free_point(edge[k]);
}

void build_triangle(Mesh& mesh, TriangleId t, const EdgePoints& e0, const EdgePoints& e1, const EdgePoints& e2,
                    const InnerPoints& inner, int rotation) {
  const std::array<const EdgePoints*, 3> edges{&e0, &e1, &e2};
  const NetLayout& layout = mesh.layout();
  for (int e = 0; e < 3; ++e) {
    const int local = (e + rotation) % 3;
    for (int k = 0; k < mesh.degree(); ++k)
      mesh.set_net_point(t, layout.edge_index(local, k), (*edges[static_cast<std::size_t>(e)])[k]);
    mesh.set_vertex_half_edge(edges[static_cast<std::size_t>(e)]->front(), half_edge(t, local));
  }
  const int first = layout.first_interior();
  for (int k = first; k < mesh.net_size(); ++k) mesh.set_net_point(t, k, inner[static_cast<std::size_t>(k - first)]);
}

void attach(Mesh& mesh, HalfEdgeId h, const Side& side) {
  mesh.link(h, side.twin);
  mesh.set_constraint(h, side.constraint);
}

bool covers_smooth_corner(const Mesh& mesh, TriangleId t) {
  for (int c = 0; c < 3; ++c) {
    const ConstraintId out = mesh.constraint(half_edge(t, c)), in = mesh.constraint(half_edge(t, (c + 2) % 3));
    if (out == none || in == none || mesh.constraint_curve(out) != mesh.constraint_curve(in)) continue;
    for (const ConstraintId k : {out, in})
      if (mesh.constraint_first(k) == mesh.corner(t, c)) {
        const BSpline& spline = mesh.spline(mesh.constraint_curve(k));
        const double knot = mesh.constraint_start(k);
        if ((spline.closed() || knot > spline.first_parameter()) && spline.multiplicity(knot) < spline.degree())
          return true;
      }
  }
  return false;
}

bool is_valid(const Mesh& mesh, TriangleId t) {
  return !covers_smooth_corner(mesh, t) && certify_element(mesh, t) == Validity::valid;
}

bool all_valid(const Mesh& mesh, std::span<const TriangleId> triangles) {
  return std::all_of(triangles.begin(), triangles.end(), [&](TriangleId t) { return is_valid(mesh, t); });
}

}  // namespace pliant
