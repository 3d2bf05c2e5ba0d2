#include "pliant/mesh/star.h"

namespace pliant {

void find_star(const Mesh& mesh, PointId v, Star& star) {
  star.outgoing.clear();
  star.is_closed = false;
  const HalfEdgeId start = mesh.vertex_half_edge(v);
  if (start < 0) return;
  // Clockwise to the outer boundary, if there is one; then all counter-clockwise from there.
  HalfEdgeId h = start;
  while (mesh.twin(h) != none) {
    h = next(mesh.twin(h));
    if (h == start) {
      star.is_closed = true;
      break;
    }
  }
  const HalfEdgeId first = h;
  do {
    star.outgoing.push_back(h);
    h = mesh.twin(previous(h));
  } while (h != none && h != first);
}

HalfEdgeId find_half_edge(const Mesh& mesh, PointId a, PointId b) {
  const HalfEdgeId start = mesh.vertex_half_edge(a);
  if (start < 0) return none;
  HalfEdgeId h = start;
  do {  // counter-clockwise
    if (mesh.target(h) == b) return h;
    h = mesh.twin(previous(h));
  } while (h != none && h != start);
  if (h == start) return none;
  for (h = mesh.twin(start); h != none; h = mesh.twin(next(h))) {  // clockwise
    if (mesh.target(next(h)) == b) return next(h);
  }
  return none;
}

bool are_joined(const Mesh& mesh, PointId a, PointId b) {
  const HalfEdgeId start = mesh.vertex_half_edge(a);
  if (start < 0) return false;
  for (HalfEdgeId h = start;;) {  // counter-clockwise; the last edge of an open star leads only to a
    if (mesh.target(h) == b || mesh.apex(h) == b) return true;
    h = mesh.twin(previous(h));
    if (h == start) return false;
    if (h == none) break;
  }
  for (HalfEdgeId h = mesh.twin(start); h != none; h = mesh.twin(next(h)))  // clockwise
    if (mesh.target(next(h)) == b) return true;
  return false;
}

bool is_on_curve(const Mesh& mesh, const Star& star) {
  if (!star.is_closed) return true;
  for (const HalfEdgeId h : star.outgoing)
    if (mesh.is_constrained(h)) return true;
  return false;
}

}  // namespace pliant
