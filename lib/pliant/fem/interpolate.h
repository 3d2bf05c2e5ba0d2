// lib/pliant/fem/interpolate.h: the interpolant of coefficients.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "pliant/fem/coefficient.h"
#include "pliant/fem/configuration.h"
#include "pliant/fem/space.h"

namespace pliant {

using CoefficientOfFace = std::function<const Coefficient&(FaceId)>;

/// The unknowns of the function that interpolates the coefficient of each face at the nodes of its elements: vertices,
/// equally spaced parameters on edges, the lattice inside. Unknowns that several faces share have the mean of theirs.
/// Requires    a space of the mesh's degree
/// Throws      InputError where the coefficient is not finite
/// Complexity  O(mesh)
std::vector<double> interpolate(const Space& space, const Mesh& mesh, const Configuration& at,
                                const CoefficientOfFace& coefficient);

/// The same along one edge: the control values of the polynomials that interpolate coefficients at equally spaced
/// parameters.
/// Shapes      values: degree + 1 rows, from the half-edge's origin to its target, each with a value for each
/// coefficient Throws      as interpolate
void interpolate_edge(const Mesh& mesh, const Configuration& at, HalfEdgeId h,
                      std::span<const Coefficient* const> coefficients, std::span<double> values);

}  // namespace pliant
