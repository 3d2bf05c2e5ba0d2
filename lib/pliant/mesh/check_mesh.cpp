// lib/pliant/mesh/check_mesh.cpp: checks M3 by certificates, and the adjacency of a live mesh against its nets.
#include "pliant/mesh/check_mesh.h"

#include <array>
#include <string>

#include "pliant/mesh/star.h"

namespace pliant {
namespace {

void judge(InvalidElements& found, const BoundaryComplex& boundary, int degree, std::span<const Point> net,
           TriangleId t) {
  switch (certify_element(boundary, degree, net)) {
    case Validity::valid:
      break;
    case Validity::degenerate:
      found.degenerate.push_back(t);
      break;
    case Validity::invalid:
      found.invalid.push_back(t);
      break;
  }
}

}  // namespace

int cusp_corner(const BoundaryComplex& boundary, std::span<const Point> net) {
  for (const int v : boundary.cusps)
    for (int c = 0; c < 3; ++c)
      if (boundary.vertices[static_cast<std::size_t>(v)] == net[static_cast<std::size_t>(c)]) return c;
  return none;
}

Validity certify_element(const BoundaryComplex& boundary, int degree, std::span<const Point> net) {
  const int cusp = boundary.cusps.empty() ? none : cusp_corner(boundary, net);
  return cusp == none ? certify(degree, net) : certify_cusp(degree, net, cusp);
}

Validity certify_element(const Mesh& mesh, TriangleId t) {
  std::array<Point, net_size(max_degree)> net;
  mesh.gather_points(t, net);
  return certify_element(mesh.boundary(), mesh.degree(), {net.data(), static_cast<std::size_t>(mesh.net_size())});
}

InvalidElements find_invalid(const Mesh& mesh) {
  InvalidElements found;
  std::vector<Point> net(static_cast<std::size_t>(mesh.net_size()));
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    mesh.gather_points(t, net);
    judge(found, mesh.boundary(), mesh.degree(), net, t);
  }
  return found;
}

InvalidElements find_invalid(const MeshData& data) {
  InvalidElements found;
  const auto n = static_cast<std::size_t>(net_size(data.degree));
  std::vector<Point> net(n);
  for (std::size_t t = 0; t < data.triangle_faces.size(); ++t) {
    for (std::size_t k = 0; k < n; ++k) net[k] = data.points[static_cast<std::size_t>(data.triangles[t * n + k])];
    judge(found, data.boundary, data.degree, net, static_cast<TriangleId>(t));
  }
  return found;
}

std::vector<Fault> check_mesh(const Mesh& mesh) {
  std::vector<Fault> faults;
  const auto fault = [&faults](TriangleId t, const std::string& text) {
    faults.push_back({"adjacency", "/triangles/" + std::to_string(t), text});
  };
  int alive = 0;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    ++alive;
    for (const PointId p : mesh.net(t))
      if (p < 0 || p >= mesh.point_slots() || !mesh.is_point_alive(p)) {
        fault(t, "names a free point");
        return faults;
      }
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e), g = mesh.twin(h);
      if (!mesh.is_vertex(mesh.origin(h))) fault(t, "a corner is not known as a vertex");
      if (g != none && (!mesh.is_alive(triangle_of(g)) || mesh.twin(g) != h || mesh.origin(g) != mesh.target(h) ||
                        mesh.target(g) != mesh.origin(h)))
        fault(t, "a twin is wrong");
      if (g != none && mesh.constraint(g) != mesh.constraint(h)) fault(t, "twins differ in their constraint");
      if (mesh.is_constrained(h)) {
        const PointId first = mesh.constraint_first(mesh.constraint(h));
        if (first != mesh.origin(h) && first != mesh.target(h)) fault(t, "a constraint's first vertex is elsewhere");
      }
    }
  }
  if (alive != mesh.triangle_count()) fault(none, "the number of triangles is wrong");
  for (PointId p = 0; p < mesh.point_slots(); ++p) {
    if (!mesh.is_vertex(p)) continue;
    const HalfEdgeId h = mesh.vertex_half_edge(p);
    if (!mesh.is_alive(triangle_of(h)) || mesh.origin(h) != p) fault(triangle_of(h), "a vertex's half-edge is wrong");
  }
  if (!faults.empty()) return faults;
  return check_structure(mesh.to_data());
}

}  // namespace pliant
