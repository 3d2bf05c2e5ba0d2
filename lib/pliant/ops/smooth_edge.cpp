#include "pliant/ops/smooth_edge.h"

#include <algorithm>
#include <array>

#include "pliant/geometry/optimal_placement.h"
#include "pliant/ops/build_triangle.h"
#include "pliant/ops/refit.h"

namespace pliant {
namespace {

/// Places the points one after the other over the given elements; true if anything moved for the better.
bool place_points(Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> points, SmoothGoal goal) {
  const auto n = static_cast<std::size_t>(mesh.net_size());
  std::array<std::array<Point, net_size(max_degree)>, 2> nets;
  std::array<PlacementElement, 2> around;
  bool moved = false;
  for (const PointId p : points) {
    std::size_t count = 0;
    for (const TriangleId t : elements) {
      const auto ids = mesh.net(t);
      const auto found = std::find(ids.begin(), ids.end(), p);
      if (found == ids.end()) continue;
      mesh.gather_points(t, nets[count]);
      around[count] = {{nets[count].data(), n}, static_cast<int>(found - ids.begin())};
      ++count;
    }
    const std::span<const PlacementElement> star{around.data(), count};
    const Placement placement = goal == SmoothGoal::improve ? improve_point(mesh.degree(), star, mesh.point(p))
                                                            : untangle_point(mesh.degree(), star, mesh.point(p));
    if (!is_finite(placement.place) || placement.place == mesh.point(p)) continue;
    mesh.set_point(p, placement.place);
    moved = true;
  }
  return moved;
}

Refusal smooth(Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> points, SmoothGoal goal,
               const RefitOptions& options) {
  if (points.empty()) return Refusal::not_removable;
  const bool was_valid = all_valid(mesh, elements);
  Transaction transaction(mesh);
  thread_local Patch patch;
  patch.capture(mesh, elements);
  if (!place_points(mesh, elements, points, goal)) return Refusal::would_invert;
  const bool now_valid = all_valid(mesh, elements);
  if (was_valid && !now_valid) return Refusal::would_invert;
  // On tangled elements the old function is not defined everywhere: then linear functions are what is kept.
  patch.fit_fields(mesh, elements, points, options, was_valid && now_valid);
  transaction.commit();
  return Refusal::done;
}

}  // namespace

Refusal smooth_edge(Mesh& mesh, HalfEdgeId h, SmoothGoal goal, const RefitOptions& options) {
  if (mesh.is_constrained(h)) return Refusal::constrained;
  if (mesh.twin(h) == none) return Refusal::outer_boundary;
  const std::array<TriangleId, 2> pair{triangle_of(h), triangle_of(mesh.twin(h))};
  const EdgePoints edge = side_of(mesh, h).points;
  return smooth(mesh, pair, {edge.ids.data() + 1, static_cast<std::size_t>(mesh.degree() - 1)}, goal, options);
}

Refusal smooth_interior(Mesh& mesh, TriangleId t, SmoothGoal goal, const RefitOptions& options) {
  const std::array<TriangleId, 1> one{t};
  const InnerPoints inner = inner_points(mesh, t);
  return smooth(mesh, one, {inner.data(), static_cast<std::size_t>(interior_size(mesh.degree()))}, goal, options);
}

}  // namespace pliant
