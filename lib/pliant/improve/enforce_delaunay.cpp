#include "pliant/improve/enforce_delaunay.h"

#include <algorithm>

#include "pliant/improve/legalize.h"

namespace pliant {

namespace {

struct Census {
  long not_delaunay = 0, inverted = 0;

  void count(EdgeState state) {
    if (state == EdgeState::not_delaunay) ++not_delaunay;
    if (state == EdgeState::inverted || state == EdgeState::turned_over) ++inverted;
  }
};

}  // namespace

PassReport enforce_delaunay(Mesh& mesh, const DelaunayOptions& options) {
  std::vector<HalfEdgeId> stack;
  Census census;
  for (HalfEdgeId h = 3 * mesh.triangle_slots() - 1; h >= 0; --h) {
    if (!mesh.is_alive(triangle_of(h)) || mesh.twin(h) > h) continue;
    const EdgeState state = edge_state(mesh, h);
    census.count(state);
    if (wants_flip(state)) stack.push_back(h);
  }
  LegalizeCounts counts;
  legalize(mesh, stack, options.refit, counts, options.max_flips);
  mesh.compact();
  if (counts.flips > 0) {
    census = {};
    for (HalfEdgeId h = 0; h < 3 * mesh.triangle_slots(); ++h)
      if (mesh.twin(h) < h) census.count(edge_state(mesh, h));
  }
  PassReport report;
  report.add("flips", static_cast<double>(counts.flips));
  report.add("not_delaunay", static_cast<double>(census.not_delaunay));
  report.add("logically_inverted", static_cast<double>(census.inverted));
  report.add("triangles", mesh.triangle_count());
  for (const auto& [reason, times] : counts.refusals) report.refuse(describe(reason), times);
  return report;
}

}  // namespace pliant
