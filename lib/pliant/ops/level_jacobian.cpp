// lib/pliant/ops/level_jacobian.cpp: collects the points that may move, then steps towards an even det J.
#include "pliant/ops/level_jacobian.h"

#include <algorithm>
#include <array>

#include "pliant/geometry/validity/jacobian.h"
#include "pliant/ops/even_jacobian.h"
#include "pliant/ops/refit/move_and_refit.h"

namespace pliant {

Outcome level_jacobian(Mesh& mesh, TriangleId t, double part, const RefitOptions& options) {
  constexpr int steps = 2;  // det J is bilinear in the points, so the second step is small already
  const int p = mesh.degree();
  std::array<TriangleId, 4> around{t};
  std::array<PointId, 3 * (max_degree - 1) + 4 * interior_size(max_degree)> points;
  std::size_t count = 1, free = 0;
  for (int e = 0; e < 3; ++e) {
    const HalfEdgeId h = half_edge(t, e);
    if (mesh.is_constrained(h) || mesh.twin(h) == none) continue;
    around[count++] = triangle_of(mesh.twin(h));
    for (int k = 1; k < p; ++k) points[free++] = mesh.edge_point(h, k);
  }
  const std::span<const TriangleId> elements{around.data(), count};
  for (const TriangleId u : elements) {
    const InnerPoints inner = inner_points(mesh, u);
    for (int k = 0; k < interior_size(p); ++k) points[free++] = inner[static_cast<std::size_t>(k)];
  }
  if (free == 0) return Outcome::constrained;
  const std::span<const PointId> movable{points.data(), free};
  return move_and_refit(mesh, elements, movable, options, [&] {
    std::array<double, 4> targets;
    std::array<Point, net_size(max_degree)> net;
    for (std::size_t e = 0; e < count; ++e) {
      mesh.gather_points(elements[e], net);
      targets[e] = 2 * element_area(p, {net.data(), static_cast<std::size_t>(mesh.net_size())});
    }
    for (int step = 0; step < steps; ++step)
      if (!step_to_even_jacobian(mesh, elements, movable, {targets.data(), count}, {}, part)) break;
  });
}

}  // namespace pliant
