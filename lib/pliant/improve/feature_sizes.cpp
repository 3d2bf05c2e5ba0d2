#include "pliant/improve/feature_sizes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant {
namespace {

constexpr double of_corner = 0.25, of_distance = 0.125;  // of a corner's size; of the distance from it

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double squared(const Mesh& mesh, HalfEdgeId h) {
  return squared_length(mesh.point(mesh.target(h)) - mesh.point(mesh.origin(h)));
}

/// Distance of a vertex from an edge that it stands opposite to; infinite if its foot is well beyond the ends.
double height_over(const Mesh& mesh, HalfEdgeId h, PointId v) {
  std::array<Point, max_degree + 1> polygon;
  mesh.gather_edge_points(h, polygon);
  const Point &a = polygon[0], &b = polygon[at(mesh.degree())], &p = mesh.point(v);
  const double foot = dot(p - a, b - a) / squared_length(b - a);
  if (!(foot > -0.2 && foot < 1.2)) return HUGE_VAL;
  double least = distance(p, a + std::clamp(foot, 0.0, 1.0) * (b - a));
  for (int k = 1; k < mesh.degree(); ++k) least = std::min(least, distance(p, polygon[at(k)]));
  return least;
}

}  // namespace

FeatureSizes::FeatureSizes(const Mesh& mesh) : sizes_(at(mesh.point_slots()), HUGE_VAL) {
  const auto lower = [this](PointId v, double size) { sizes_[at(v)] = std::min(sizes_[at(v)], size); };
  for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h) {
    if (!mesh.is_alive(triangle_of(h))) continue;
    const double length = std::sqrt(squared(mesh, h));
    lower(mesh.origin(h), length);
    lower(mesh.target(h), length);
    if (mesh.is_constrained(h)) lower(mesh.apex(h), height_over(mesh, h, mesh.apex(h)));
  }
}

void FeatureSizes::set(const Mesh& mesh, const Star& star, double inherited, const SharpCorners& corners) {
  const PointId v = mesh.origin(star.outgoing.front());
  if (sizes_.size() <= at(v)) sizes_.resize(2 * at(v) + 1, 0);
  double& size = sizes_[at(v)];
  if (inherited == 0) {
    double least = HUGE_VAL;
    for (const HalfEdgeId h : star.outgoing) least = std::min(least, squared(mesh, h));
    if (!star.is_closed) least = std::min(least, squared(mesh, previous(star.outgoing.back())));
    size = std::sqrt(least);
    return;
  }
  size = inherited;
  if (!is_on_curve(mesh, star)) return;
  for (const HalfEdgeId h : star.outgoing) {
    if (mesh.is_constrained(h) || mesh.is_constrained(previous(h)) || !mesh.is_constrained(next(h))) continue;
    double height = height_over(mesh, next(h), v);
    if (height >= size) continue;
    // Two sides of one corner come as close as one likes: there it is the corner that counts, and how far it is.
    const PointId corner = corners.shared(mesh, v, mesh.target(h), mesh.face(triangle_of(h)));
    if (corner != none)
      height = std::max({height, of_corner * of(corner), of_distance * distance(mesh.point(corner), mesh.point(v))});
    size = std::min(size, height);
  }
}

}  // namespace pliant
