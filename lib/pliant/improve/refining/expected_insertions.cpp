// lib/pliant/improve/refining/expected_insertions.cpp: roughly how many points a refinement will insert.
#include "pliant/improve/refining/expected_insertions.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

// Refined elements are smaller than they must be. Measured: the bound on area is 1.75 times their mean area, and the
// square of the wanted size is 2.57 times their mean area.
constexpr double bounds_per_mean_area = 1.75, squared_sizes_per_mean_area = 2.57;
// In each triangle the size is evaluated on a lattice of n points a side, n (n + 1) / 2 in all. Summed over the
// triangles, n squared is about this.
constexpr long sum_of_squared_sides = 100'000;
constexpr int most_points_a_side = 100;
constexpr double least_displayed = 1000;  // fewer points go in so fast that nobody waits for them

}  // namespace

double expected_insertions(const Mesh& mesh, const QualityGoals& goals) {
  double triangles = 0;
  const int each = std::clamp(static_cast<int>(std::sqrt(sum_of_squared_sides / (1.0 + mesh.triangle_count()))), 1,
                              most_points_a_side);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    const Point &a = mesh.point(mesh.corner(t, 0)), &b = mesh.point(mesh.corner(t, 1)),
                &c = mesh.point(mesh.corner(t, 2));
    const double area = std::fabs(cross(b - a, c - a)) / 2,
                 bound = goals.area_bound(mesh.face(t)) / bounds_per_mean_area;
    if (!goals.size) {
      triangles += std::max(1.0, area / bound);
      continue;
    }
    double inside = 0;
    for (int i = 0; i < each; ++i)
      for (int j = 0; i + j < each; ++j) {
        const double u = (i + 1.0 / 3) / each, v = (j + 1.0 / 3) / each;
        const double size = goals.size(a + u * (b - a) + v * (c - a), mesh.time);
        const double wanted = size > 0 ? std::min(bound, size * size / squared_sizes_per_mean_area) : bound;
        inside += area / (0.5 * each * (each + 1)) / wanted;
      }
    triangles += std::max(1.0, inside);
  }
  const double points = (triangles - mesh.triangle_count()) / 2;  // a point inside makes two triangles more
  return points > least_displayed && std::isfinite(points) ? points : 0;
}

}  // namespace pliant
