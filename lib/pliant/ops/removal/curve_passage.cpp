// lib/pliant/ops/removal/curve_passage.cpp: walks from a vertex along its curve, and around the vertex.
#include "pliant/ops/removal/curve_passage.h"

#include <algorithm>

namespace pliant {
namespace {

/// Lists one half-edge for each edge of the star that lies on a curve: the one that leaves the vertex, or, at the last
/// edge of an open star, the one that arrives.
void constrained_at(const Mesh& mesh, const Star& star, std::vector<HalfEdgeId>& edges) {
  edges.clear();
  for (const HalfEdgeId h : star.outgoing)
    if (mesh.is_constrained(h)) edges.push_back(h);
  if (!star.is_closed && !star.outgoing.empty()) edges.push_back(previous(star.outgoing.back()));
}

/// A half-edge of the next edge along the same curve (the one before, unless `forward`), or none at the curve's end.
HalfEdgeId step_along(const Mesh& mesh, HalfEdgeId h, bool forward) {
  const ConstraintId c = mesh.constraint(h);
  const PointId first = mesh.constraint_first(c);
  const PointId last = mesh.origin(h) == first ? mesh.target(h) : mesh.origin(h);
  const PointId v = forward ? last : first;
  Star star;
  find_star(mesh, v, star);
  std::vector<HalfEdgeId> edges;
  constrained_at(mesh, star, edges);
  for (const HalfEdgeId g : edges) {
    const ConstraintId other = mesh.constraint(g);
    if (other == none || other == c || mesh.constraint_curve(other) != mesh.constraint_curve(c)) continue;
    if ((mesh.constraint_first(other) == v) == forward) return g;
  }
  return none;
}

}  // namespace

Passage passage_at(const Mesh& mesh, PointId v, const Star& star) {
  if (star.components != 1 || mesh.is_lone_vertex(v)) return {};
  thread_local std::vector<HalfEdgeId> edges;
  constrained_at(mesh, star, edges);
  if (edges.size() != 2) return {};
  Passage passage;
  for (const HalfEdgeId h : edges) {
    if (!mesh.is_constrained(h)) return {};
    const ConstraintId c = mesh.constraint(h);
    if (passage.curve != none && passage.curve != mesh.constraint_curve(c)) return {};
    passage.curve = mesh.constraint_curve(c);
    (mesh.constraint_first(c) == v ? passage.after : passage.before) = h;
  }
  if (passage.before == none || passage.after == none) return {};
  return passage;
}

void find_footprint(const Mesh& mesh, const Passage& passage, Footprint& footprint, int more) {
  footprint = {};
  std::vector<ConstraintId> seen{mesh.constraint(passage.before), mesh.constraint(passage.after)};
  for (const bool forward : {false, true}) {
    HalfEdgeId h = forward ? passage.after : passage.before;
    for (int k = 1; k <= mesh.degree() + more; ++k) {
      h = step_along(mesh, h, forward);
      if (h == none || std::find(seen.begin(), seen.end(), mesh.constraint(h)) != seen.end()) break;
      seen.push_back(mesh.constraint(h));
      footprint.edges.push_back(mesh.constraint(h));
      footprint.half_edges.push_back(h);
    }
  }
}

void find_fan(const Mesh& mesh, const Star& star, HalfEdgeId first, Fan& fan) {
  fan.clear();
  const auto count = star.outgoing.size();
  const auto start =
      static_cast<std::size_t>(std::find(star.outgoing.begin(), star.outgoing.end(), first) - star.outgoing.begin());
  for (std::size_t k = 0; k < count; ++k) {
    const HalfEdgeId h = star.outgoing[(start + k) % count];
    fan.push_back(mesh.target(h));
    if (mesh.is_constrained(previous(h))) {
      fan.push_back(mesh.origin(previous(h)));
      return;
    }
  }
}

}  // namespace pliant
