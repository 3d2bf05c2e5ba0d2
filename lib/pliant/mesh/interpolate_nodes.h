// lib/pliant/mesh/interpolate_nodes.h: a function of place, brought into the basis of the mesh (paper §6.1).
#pragma once
#include <functional>
#include <span>
#include <string>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// Values of a function at a place; the span has as many entries as the function has components.
using NodeFunction = std::function<void(const Point& place, std::span<double> value)>;

/// Control values of the function that interpolates `function` at the elements' nodes: vertices, equally spaced
/// parameters of each edge, the lattice inside. Order degree + 1.
///
/// Shapes      rows: point_slots x width; known: point_slots. Control points with known[p] != 0 keep their row on
///             entry; either all or none of the points inside one edge are known.
/// Ensures     every control point of the triangles of `face` (none: of all triangles) is known; each is computed once
/// Complexity  O(mesh)
void interpolate_nodes(const Mesh& mesh, FaceId face, int width, const NodeFunction& function, std::span<char> known,
                       std::span<double> rows);

/// The field of that name and number of components that interpolates `function`, ready for Mesh::set_field.
///
/// With a face (not none) the field is by face: the function stands on that face; on the others the field of the same
/// name keeps its values (a continuous one becomes by face), and is 0 if there is none.
/// Refuses     a function that is not finite at a node, or an old field with another number of components: the field
///             returned has no values, and `why` says what
Field make_field(const Mesh& mesh, const std::string& name, int components, FaceId face, const NodeFunction& function,
                 std::string& why);

}  // namespace pliant
