// lib/pliant/mesh/star.cpp: walks around a vertex, one component of its star after the other.
#include "pliant/mesh/star.h"

#include <algorithm>

namespace pliant {

namespace {

/// Adds the component of a star that contains `start`, if it is not there yet. True if a component was added that goes
/// all the way round.
bool add_component(const Mesh& mesh, HalfEdgeId start, Star& star) {
  if (star.components > 0 && std::find(star.outgoing.begin(), star.outgoing.end(), start) != star.outgoing.end())
    return false;
  ++star.components;
  // First clockwise as far as the outer boundary, if there is one; from there counter-clockwise, adding half-edges.
  bool is_closed = false;
  HalfEdgeId h = start;
  while (mesh.twin(h) != none) {
    h = next(mesh.twin(h));
    if (h == start) {
      is_closed = true;
      break;
    }
  }
  const HalfEdgeId first = h;
  do {
    star.outgoing.push_back(h);
    h = mesh.twin(previous(h));
  } while (h != none && h != first);
  return is_closed;
}

/// The first half-edge that `is_wanted` takes, in the component of a star that contains `start`; or none. Goes
/// counter-clockwise from `start`, then clockwise.
template <class IsWanted>
HalfEdgeId find_around(const Mesh& mesh, HalfEdgeId start, IsWanted is_wanted) {
  HalfEdgeId h = start;
  do {
    if (is_wanted(h)) return h;
    h = mesh.twin(previous(h));
  } while (h != none && h != start);
  if (h == start) return none;
  for (h = mesh.twin(start); h != none; h = mesh.twin(next(h)))
    if (is_wanted(next(h))) return next(h);
  return none;
}

/// The same over all components of the star of v.
template <class IsWanted>
HalfEdgeId find_at(const Mesh& mesh, PointId v, IsWanted is_wanted) {
  if (!mesh.is_vertex(v)) return none;
  HalfEdgeId found = find_around(mesh, mesh.vertex_half_edge(v), is_wanted);
  if (found != none) return found;
  for (const HalfEdgeId h : mesh.pinched_half_edges(v))
    if (mesh.is_alive(triangle_of(h)) && mesh.origin(h) == v && (found = find_around(mesh, h, is_wanted)) != none)
      return found;
  return none;
}

/// A walk over the half-edges that leave a vertex which is not pinched.
struct Walk {
  const Mesh& mesh;
  HalfEdgeId start, h;
  bool is_clockwise = false;

  Walk(const Mesh& around, PointId v) : mesh(around), start(around.vertex_half_edge(v)), h(start) {}
  /// Goes to the next half-edge; false when all have been seen.
  bool step() {
    if (!is_clockwise) {
      h = mesh.twin(previous(h));
      if (h != none) return h != start;
      is_clockwise = true;
      h = start;
    }
    const HalfEdgeId g = mesh.twin(h);
    h = g == none ? none : next(g);
    return h != none;
  }
};

/// Calls `from_a` with the half-edges that leave a and `from_b` with those that leave b, in turn, until one call gives
/// a half-edge or either star is done. So it takes no longer than a walk around the smaller star.
template <class FromA, class FromB>
HalfEdgeId find_at_either(const Mesh& mesh, PointId a, PointId b, FromA from_a, FromB from_b) {
  if (!mesh.is_vertex(a) || !mesh.is_vertex(b)) return none;
  Walk at_a(mesh, a), at_b(mesh, b);
  do {
    if (const HalfEdgeId found = from_a(at_a.h); found != none) return found;
    if (const HalfEdgeId found = from_b(at_b.h); found != none) return found;
  } while (at_a.step() && at_b.step());
  return none;
}

}  // namespace

void find_star(const Mesh& mesh, PointId v, Star& star) {
  star.outgoing.clear();
  star.is_closed = false;
  star.components = 0;
  if (!mesh.is_vertex(v)) return;
  star.is_closed = add_component(mesh, mesh.vertex_half_edge(v), star);
  for (const HalfEdgeId h : mesh.pinched_half_edges(v))
    if (mesh.is_alive(triangle_of(h)) && mesh.origin(h) == v) add_component(mesh, h, star);
}

HalfEdgeId find_half_edge(const Mesh& mesh, PointId a, PointId b) {
  const auto from_a = [&mesh, b](HalfEdgeId h) { return mesh.target(h) == b; };
  if (mesh.is_pinched(a) || mesh.is_pinched(b)) return find_at(mesh, a, from_a);
  return find_at_either(
      mesh, a, b, [&](HalfEdgeId h) { return from_a(h) ? h : none; },
      [&mesh, a](HalfEdgeId h) { return mesh.apex(h) == a ? previous(h) : none; });
}

bool are_joined(const Mesh& mesh, PointId a, PointId b) {
  // The last edge of an open star has no half-edge that leaves a, so both other corners of each triangle are compared.
  const auto leads_to = [&mesh](HalfEdgeId h, PointId v) { return mesh.target(h) == v || mesh.apex(h) == v; };
  if (mesh.is_pinched(a) || mesh.is_pinched(b))
    return find_at(mesh, a, [&](HalfEdgeId h) { return leads_to(h, b); }) != none;
  return find_at_either(
             mesh, a, b, [&](HalfEdgeId h) { return leads_to(h, b) ? h : none; },
             [&](HalfEdgeId h) { return leads_to(h, a) ? h : none; }) != none;
}

bool is_on_curve(const Mesh& mesh, const Star& star) {
  if (!star.is_closed || mesh.is_lone_vertex(mesh.origin(star.outgoing.front()))) return true;
  for (const HalfEdgeId h : star.outgoing)
    if (mesh.is_constrained(h)) return true;
  return false;
}

}  // namespace pliant
