#include "pliant/improve/legalize.h"

#include "pliant/geometry/predicates.h"
#include "pliant/ops/flip_edge.h"

namespace pliant {

EdgeState edge_state(const Mesh& mesh, HalfEdgeId h) {
  const HalfEdgeId g = mesh.twin(h);
  if (g == none || mesh.is_constrained(h)) return EdgeState::delaunay;
  const Point &a = mesh.point(mesh.origin(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.apex(h)),
              &d = mesh.point(mesh.apex(g));
  const int above = orient2d(a, b, c), below = orient2d(b, a, d);
  const auto flips_to_positive = [&] { return orient2d(a, d, c) > 0 && orient2d(d, b, c) > 0; };
  if (above <= 0 || below <= 0)
    return (above > 0 || below > 0) && flips_to_positive() ? EdgeState::turned_over : EdgeState::inverted;
  if (in_circle(a, b, c, d) <= 0) return EdgeState::delaunay;
  // A point inside the circle beyond ab sees the quadrilateral convex; the exact test guards the flat cases.
  return flips_to_positive() ? EdgeState::not_delaunay : EdgeState::inverted;
}

void LegalizeCounts::refuse(Refusal reason) {
  for (auto& [known, count] : refusals)
    if (known == reason) {
      ++count;
      return;
    }
  refusals.emplace_back(reason, 1);
}

void legalize(Mesh& mesh, std::vector<HalfEdgeId>& stack, const RefitOptions& refit, LegalizeCounts& counts,
              long max_flips, std::vector<TriangleId>* touched) {
  while (!stack.empty()) {
    const HalfEdgeId h = stack.back();
    stack.pop_back();
    if (!mesh.is_alive(triangle_of(h)) || !wants_flip(edge_state(mesh, h))) continue;
    if (max_flips >= 0 && counts.flips >= max_flips) continue;
    const Refusal refusal = flip_edge(mesh, h, refit);
    if (refusal != Refusal::done) {
      counts.refuse(refusal);
      continue;
    }
    ++counts.flips;
    const HalfEdgeId g = mesh.twin(h);
    for (const HalfEdgeId outer : {next(h), previous(h), next(g), previous(g)}) stack.push_back(outer);
    if (touched) {
      touched->push_back(triangle_of(h));
      touched->push_back(triangle_of(g));
    }
  }
}

}  // namespace pliant
