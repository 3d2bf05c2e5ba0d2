// lib/pliant/fem/interpolate.h: the interpolant of coefficients.
#pragma once
#include <functional>
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

}  // namespace pliant
