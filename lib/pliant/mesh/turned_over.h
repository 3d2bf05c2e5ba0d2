// lib/pliant/mesh/turned_over.h: is a straight triangle, or the logical triangle of an element, turned over?
#pragma once
#include "pliant/geometry/predicates.h"
#include "pliant/mesh/mesh.h"

namespace pliant {

/// True if the corners do not turn counter-clockwise: the triangle is turned over or flat. Exact.
inline bool is_turned_over(const Point& a, const Point& b, const Point& c) { return orient2d(a, b, c) <= 0; }

/// The same for the logical triangle of an element, that is the straight one on its three vertices.
inline bool is_turned_over(const Mesh& mesh, TriangleId t) {
  return is_turned_over(mesh.point(mesh.corner(t, 0)), mesh.point(mesh.corner(t, 1)), mesh.point(mesh.corner(t, 2)));
}

}  // namespace pliant
