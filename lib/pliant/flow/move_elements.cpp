// lib/pliant/flow/move_elements.cpp: extracts edges from the moved curves, then completes the displacements.
#include "pliant/flow/move_elements.h"

namespace pliant {

std::vector<Point> move_elements(const Mesh& mesh, const MovedBoundary& boundary, const FillDisplacements& fill) {
  const auto slots = static_cast<std::size_t>(mesh.point_slots());
  std::vector<char> known(slots, 0);
  std::vector<double> displacements(2 * slots);
  std::vector<Point> points(slots);
  std::vector<Point> polygon(static_cast<std::size_t>(mesh.degree()) + 1);
  for (std::size_t p = 0; p < slots; ++p) points[p] = mesh.point(static_cast<PointId>(p));
  for (const HalfEdgeId h : mesh.half_edges()) {
    // An edge that two elements share is extracted once.
    if (!mesh.is_alive(triangle_of(h)) || !mesh.is_constrained(h) || (mesh.twin(h) != none && mesh.twin(h) < h))
      continue;
    const ConstraintId c = mesh.constraint(h);
    boundary.splines[static_cast<std::size_t>(mesh.constraint_curve(c))].extract(mesh.constraint_start(c), polygon);
    const bool forward = mesh.runs_forward(h);
    for (int k = 0; k <= mesh.degree(); ++k) {
      const PointId p = mesh.edge_point(h, forward ? k : mesh.degree() - k);
      if (known[static_cast<std::size_t>(p)]) continue;
      known[static_cast<std::size_t>(p)] = 1;
      points[static_cast<std::size_t>(p)] = polygon[static_cast<std::size_t>(k)];
      const Vector moved = polygon[static_cast<std::size_t>(k)] - mesh.point(p);
      displacements[2 * static_cast<std::size_t>(p)] = moved.x;
      displacements[2 * static_cast<std::size_t>(p) + 1] = moved.y;
    }
  }
  const std::vector<char> is_boundary = known;
  fill(known, displacements);
  for (std::size_t p = 0; p < slots; ++p)
    if (!is_boundary[p]) points[p] += {displacements[2 * p], displacements[2 * p + 1]};
  return points;
}

}  // namespace pliant
