// lib/pliant/fem/element_values.h: fields of the mesh as vectors of unknowns, and as values of element after element.
#pragma once
#include <span>
#include <vector>

#include "pliant/fem/space.h"

namespace pliant {

/// The control values of one component of a field, in the basis of element after element.
///
/// Shapes      triangles x net_size, in the order of NetLayout
std::vector<double> element_values(const Mesh& mesh, int field, int component);
/// The same of a function that is given by its unknowns.
std::vector<double> element_values(const Space& space, std::span<const double> unknowns);

/// The same in the basis of a higher degree: as a field of the mesh has it.
std::vector<double> elevated_values(const Space& space, std::span<const double> unknowns, int degree);

/// The unknowns that have these values; where elements differ, the value of the first one that names the unknown.
std::vector<double> unknowns_of(const Space& space, std::span<const double> element_values);

/// The unknowns of a function that is given by values of element after element in the basis of a higher degree, as
/// elevated_values makes them. A function that is not of the space's degree is interpolated at the nodes of that
/// degree.
std::vector<double> restricted_unknowns(const Space& space, std::span<const double> element_values, int degree);

/// A copy of a field of one component with the values of these unknowns.
/// Requires    a space of the mesh's degree; the field is by face if the unknowns differ between faces
Field with_unknowns(const Mesh& mesh, int field, const Space& space, std::span<const double> unknowns);

}  // namespace pliant
