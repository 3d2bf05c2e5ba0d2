// lib/pliant/improve/refining/expected_insertions.cpp: roughly how many points a refinement will insert.
#include "pliant/improve/refining/expected_insertions.h"

#include <algorithm>
#include <cmath>

namespace pliant {

double expected_insertions(const Mesh& mesh, const QualityGoals& goals) {
  // Measured: areas end at 1/1.75 of their bound on the average, and at size^2/2.57.
  double triangles = 0;
  constexpr long samples = 100'000;
  const int each = std::clamp(static_cast<int>(std::sqrt(samples / (1.0 + mesh.triangle_count()))), 1, 100);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    if (!mesh.is_alive(t)) continue;
    const Point &a = mesh.point(mesh.corner(t, 0)), &b = mesh.point(mesh.corner(t, 1)),
                &c = mesh.point(mesh.corner(t, 2));
    const double area = std::fabs(cross(b - a, c - a)) / 2, bound = goals.area_bound(mesh.face(t)) / 1.75;
    if (!goals.size) {
      triangles += std::max(1.0, area / bound);
      continue;
    }
    double inside = 0;
    for (int i = 0; i < each; ++i)
      for (int j = 0; i + j < each; ++j) {
        const double u = (i + 1.0 / 3) / each, v = (j + 1.0 / 3) / each;
        const double size = goals.size(a + u * (b - a) + v * (c - a), mesh.time);
        const double wanted = size > 0 ? std::min(bound, size * size / 2.57) : bound;
        inside += area / (0.5 * each * (each + 1)) / wanted;
      }
    triangles += std::max(1.0, inside);
  }
  const double points = (triangles - mesh.triangle_count()) / 2;
  return points > 1000 && std::isfinite(points) ? points : 0;
}

}  // namespace pliant
