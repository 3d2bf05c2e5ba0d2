// lib/pliant/improve/global/free_points.cpp: which points are free, and in which blocks; nets with their new places.
#include "pliant/improve/global/free_points.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/index.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/mesh/star.h"
#include "pliant/ops/build_triangle.h"

namespace pliant {

FreePoints::FreePoints(const Mesh& mesh)
    : mesh_(&mesh), slots_(index(mesh.point_slots()), none), block_of_(index(mesh.point_slots()), none) {
  const double size = mesh.size() / std::sqrt(std::max(1, mesh.triangle_count()));
  if (size > 0) unit_ = std::ldexp(1, std::ilogb(size));
  points_.reserve(slots_.size());
  coordinates_.reserve(slots_.size());
  Star star;
  std::vector<PointId> points;
  std::vector<char> seen(slots_.size(), 0);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e);
      if (mesh.twin(h) > h && !mesh.is_constrained(h)) {
        points.clear();
        for (int k = 1; k < mesh.degree(); ++k) points.push_back(mesh.edge_point(h, k));
        add(points, 2, false);
      }
      const PointId v = mesh.corner(t, e);
      if (seen[index(v)]) continue;
      seen[index(v)] = 1;
      find_star(mesh, v, star);
      if (star.is_closed && !is_on_curve(mesh, star)) add({&v, 1}, star.degree(), true);
    }
    const InnerPoints inner = inner_points(mesh, t);
    add({inner.data(), index(interior_size(mesh.degree()))}, 1, false);
  }
  for (PointId p = 0; p < mesh.point_slots(); ++p)
    if (slots_[index(p)] == none) put(p);
}

void FreePoints::put(PointId p) {
  slots_[index(p)] = static_cast<int>(points_.size());
  points_.push_back(p);
  const Point& x = mesh_->point(p);
  coordinates_.push_back({x.x / unit_, x.y / unit_});
}

void FreePoints::add(std::span<const PointId> points, int elements, bool is_vertex) {
  if (points.empty()) return;
  blocks_.push_back({static_cast<int>(points_.size()), static_cast<int>(points.size()), elements, is_vertex});
  for (const PointId p : points) {
    block_of_[index(p)] = static_cast<int>(blocks_.size()) - 1;
    put(p);
  }
}

std::span<const Point> FreePoints::gather(TriangleId t, Net& net) const {
  const auto ids = mesh_->net(t);
  for (std::size_t k = 0; k < ids.size(); ++k) net[k] = place(ids[k]);
  return {net.data(), ids.size()};
}

bool FreePoints::is_valid(TriangleId t) const {
  Net net;
  return is_valid(gather(t, net));
}

bool FreePoints::is_valid(std::span<const Point> net) const {
  Net scaled;
  for (std::size_t k = 0; k < net.size(); ++k) scaled[k] = unit_ * net[k];
  return certify_element(mesh_->boundary(), mesh_->degree(), {scaled.data(), net.size()}) == Validity::valid;
}

}  // namespace pliant
