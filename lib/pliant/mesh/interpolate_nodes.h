// lib/pliant/mesh/interpolate_nodes.h: control values of a function of position, by interpolation (paper §6.1).
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// A function of position: writes its values at `place`, one for each component, into `value`.
using NodeFunction = std::function<void(const Point& place, std::span<double> value)>;

/// Computes the control values of the polynomials that interpolate `function` at the elements' nodes: the vertices,
/// equally spaced parameters on each edge, the lattice inside. The error is of order degree + 1.
///
/// Shapes      rows: point_slots x width; known: point_slots. Control points with known[p] != 0 on entry keep their row
/// Requires    all or none of the points inside any one edge are known
/// Ensures     every control point of the triangles of `face` is known (of all triangles, if `face` is none); each is
///             computed once
/// Complexity  O(mesh)
void interpolate_nodes(const Mesh& mesh, FaceId face, int width, const NodeFunction& function, std::span<char> known,
                       std::span<double> rows);

/// A field with this name and number of components that interpolates `function`, ready for Mesh::set_field.
///
/// If `face` is not none, the result is a field by face. It interpolates `function` on that face only. On the other
/// faces it has the values of the mesh's field of the same name (which may be continuous), or 0 if there is none.
///
/// Refuses     a function that is not finite at a node, and a face where the mesh's field of this name has another
///             number of components: the result then has no values, and `why` says why; otherwise `why` is empty
Field make_field(const Mesh& mesh, const std::string& name, int components, FaceId face, const NodeFunction& function,
                 std::string& why);

/// The index of the field of that name; none if there is none.
int find_field(const Mesh& mesh, const std::string& name);

/// Every pair of a point and a face that has the point in one of its elements, sorted: the places of a field by face.
std::vector<std::array<std::int32_t, 2>> field_places(const Mesh& mesh);

}  // namespace pliant
