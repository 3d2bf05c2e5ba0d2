// lib/pliant/generate/patch_region.cpp: grows a region around vertices, and makes a boundary of its border.
#include "pliant/generate/patch_region.h"

#include <array>
#include <unordered_map>

#include "pliant/geometry/index.h"
#include "pliant/mesh/turned_over.h"

namespace pliant {
namespace {

/// Calls visit(u) for each triangle u that has a corner in common with t, and is reached around that corner without
/// crossing a constrained edge.
template <class Visit>
void visit_around(const Mesh& mesh, TriangleId t, const Visit& visit) {
  for (int c = 0; c < 3; ++c) {
    const HalfEdgeId start = half_edge(t, c);
    HalfEdgeId h = start;
    do {  // counter-clockwise
      h = mesh.is_constrained(previous(h)) ? none : mesh.twin(previous(h));
      if (h != none && h != start) visit(triangle_of(h));
    } while (h != none && h != start);
    if (h == start) continue;
    for (h = start; h != none;) {  // what lies clockwise of it, up to the next curve
      const HalfEdgeId g = mesh.is_constrained(h) ? none : mesh.twin(h);
      h = g == none ? none : next(g);
      if (h != none) visit(triangle_of(h));
    }
  }
}

}  // namespace

PatchRegion::PatchRegion(const Mesh& mesh, const std::vector<char>& invalid, TriangleId seed)
    : mesh_(mesh), invalid_(invalid) {
  add(seed);
  add_cluster();
  grow(1);
}

void PatchRegion::add(TriangleId t) {
  if (contains(t)) return;
  if (index(t) >= member_.size()) member_.resize(index(mesh_.triangle_slots()), 0);
  member_[index(t)] = 1;
  triangles_.push_back(t);
}

bool PatchRegion::grow(int rings) {
  const std::size_t before = triangles_.size();
  for (int k = 0; k < rings; ++k) {
    while (add_ring() && add_cluster()) {
    }
    fill_notches();
  }
  return triangles_.size() > before;
}

bool PatchRegion::add_ring() {
  const std::size_t count = triangles_.size();
  for (std::size_t k = 0; k < count; ++k) visit_around(mesh_, triangles_[k], [this](TriangleId t) { add(t); });
  return triangles_.size() > count;
}

/// Adds the invalid elements that touch the region, and elements beside them that are turned over.
bool PatchRegion::add_cluster() {
  const std::size_t count = triangles_.size();
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    const bool beside_invalid = is_invalid(triangles_[k]);
    visit_around(mesh_, triangles_[k], [&](TriangleId t) {
      if (is_invalid(t) || (beside_invalid && is_turned_over(mesh_, t))) add(t);
    });
  }
  return triangles_.size() > count;
}

/// Adds elements outside that have two edges on the border. Such an element fills a notch of the region, and its third
/// edge joins two vertices that a new edge inside the region might join, too.
void PatchRegion::fill_notches() {
  for (std::size_t k = 0; k < triangles_.size(); ++k)
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(triangles_[k], e), g = mesh_.is_constrained(h) ? none : mesh_.twin(h);
      if (g == none || contains(triangle_of(g))) continue;
      int shared = 0;
      for (const HalfEdgeId side : {g, next(g), previous(g)})
        shared += !mesh_.is_constrained(side) && mesh_.twin(side) != none && contains(triangle_of(mesh_.twin(side)));
      if (shared >= 2) add(triangle_of(g));
    }
}

RegionBoundary boundary_of(const Mesh& mesh, const PatchRegion& region) {
  RegionBoundary result;
  std::unordered_map<PointId, int> numbers;
  const auto number_of = [&](PointId p) {
    const auto [found, is_new] = numbers.try_emplace(p, static_cast<int>(result.vertices.size()));
    if (is_new) {
      result.vertices.push_back(p);
      result.complex.vertices.push_back(mesh.point(p));
    }
    return found->second;
  };
  result.complex.faces.resize(1);
  result.complex.faces.front().name = "patch";
  const auto n = static_cast<std::size_t>(mesh.degree() + 1);
  std::vector<double> knots(n, 0.0);
  knots.resize(2 * n, 1.0);
  for (const TriangleId t : region.triangles())
    for (int e = 0; e < 3; ++e) {
      const HalfEdgeId h = half_edge(t, e), g = mesh.twin(h);
      const bool is_inside = g != none && region.contains(triangle_of(g));
      if (is_inside && (!mesh.is_constrained(h) || g < h)) continue;
      std::vector<Point> points(n);
      mesh.gather_edge_points(h, points);
      Curve curve;
      curve.spline = BSpline(mesh.degree(), false, knots, std::move(points));
      curve.start = number_of(mesh.origin(h));
      curve.end = number_of(mesh.target(h));
      curve.left = 0;
      curve.right = is_inside ? 0 : outside;
      result.complex.curves.push_back(std::move(curve));
      result.border.push_back({mesh.origin(h), mesh.target(h), is_inside});
    }
  for (const TriangleId t : region.triangles())
    for (int c = 0; c < 3; ++c)
      if (mesh.is_lone_vertex(mesh.corner(t, c))) number_of(mesh.corner(t, c));
  return result;
}

}  // namespace pliant
