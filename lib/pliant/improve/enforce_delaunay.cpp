#include "pliant/improve/enforce_delaunay.h"

#include <algorithm>

#include "pliant/improve/legalize.h"

namespace pliant {

PassReport enforce_delaunay(Mesh& mesh, const DelaunayOptions& options) {
  std::vector<HalfEdgeId> stack;
  for (HalfEdgeId h = 3 * mesh.triangle_slots() - 1; h >= 0; --h)
    if (mesh.is_alive(triangle_of(h)) && mesh.twin(h) < h && wants_flip(edge_state(mesh, h))) stack.push_back(h);
  LegalizeCounts counts;
  legalize(mesh, stack, options.refit, counts, options.max_flips);
  mesh.compact();

  long not_delaunay = 0, inverted = 0;
  for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h) {
    if (mesh.twin(h) > h) continue;
    const EdgeState state = edge_state(mesh, h);
    if (state == EdgeState::not_delaunay) ++not_delaunay;
    if (state == EdgeState::inverted || state == EdgeState::turned_over) ++inverted;
  }
  PassReport report;
  report.add("flips", static_cast<double>(counts.flips));
  report.add("not_delaunay", static_cast<double>(not_delaunay));
  report.add("logically_inverted", static_cast<double>(inverted));
  report.add("triangles", mesh.triangle_count());
  for (const auto& [reason, times] : counts.refusals) report.refuse(describe(reason), times);
  return report;
}

}  // namespace pliant
