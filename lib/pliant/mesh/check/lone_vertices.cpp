// lib/pliant/mesh/check/lone_vertices.cpp: a search among the mesh's vertices, sorted by x.
#include "pliant/mesh/check/lone_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/geometry/index.h"
#include "pliant/geometry/net_layout.h"

namespace pliant {
namespace {

// A mesh vertex is at a place if it is no farther off than the larger of these two.
constexpr double near = 1e-12;   // times the mesh's size
constexpr double roundings = 4;  // times the epsilon of doubles times the mesh's largest coordinate

}  // namespace

std::vector<LoneVertex> find_lone_vertices(const MeshData& data) {
  return find_lone_vertices(data.boundary, data.degree, data.points, data.triangles);
}

std::vector<LoneVertex> find_lone_vertices(const BoundaryComplex& boundary, int degree, std::span<const Point> points,
                                           std::span<const PointId> triangles) {
  std::vector<bool> ends(boundary.vertices.size(), false);
  for (const Curve& curve : boundary.curves)
    for (const int v : {curve.start, curve.end})
      if (v >= 0 && index(v) < ends.size()) ends[index(v)] = true;
  std::vector<LoneVertex> lone;
  for (int v = 0; v < static_cast<int>(ends.size()); ++v)
    if (!ends[index(v)]) lone.push_back({v, none});
  if (lone.empty()) return lone;

  Box box;
  for (const Point& p : points) box.extend(p);
  const double largest =
      std::max({std::fabs(box.low.x), std::fabs(box.low.y), std::fabs(box.high.x), std::fabs(box.high.y)});
  const double tolerance = std::max(near * box.size(), roundings * std::numeric_limits<double>::epsilon() * largest);
  std::vector<PointId> corners;
  const std::size_t n = index(net_size(degree));
  for (std::size_t k = 0; k + n <= triangles.size(); k += n)
    corners.insert(corners.end(), triangles.begin() + static_cast<std::ptrdiff_t>(k),
                   triangles.begin() + static_cast<std::ptrdiff_t>(k) + 3);
  const auto x_of = [&](PointId p) { return points[index(p)].x; };
  std::sort(corners.begin(), corners.end(),
            [&](PointId p, PointId q) { return x_of(p) < x_of(q) || (x_of(p) == x_of(q) && p < q); });
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  for (LoneVertex& each : lone) {
    const Point& place = boundary.vertices[index(each.vertex)];
    double nearest = tolerance;
    auto next = std::lower_bound(corners.begin(), corners.end(), place.x - tolerance,
                                 [&](PointId p, double x) { return x_of(p) < x; });
    for (; next != corners.end() && x_of(*next) <= place.x + tolerance; ++next) {
      const double off = distance(points[index(*next)], place);
      if (off > nearest || (off == nearest && each.point != none)) continue;
      nearest = off;
      each.point = *next;
    }
  }
  return lone;
}

}  // namespace pliant
