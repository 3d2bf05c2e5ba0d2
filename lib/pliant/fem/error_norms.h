// lib/pliant/fem/error_norms.h: how far a field is from a function.
#pragma once
#include <optional>
#include <span>
#include <string>

#include "pliant/fem/coefficient.h"

namespace pliant {

/// Norms of a difference over those faces that have a function to compare with.
struct ErrorNorms {
  double l2 = 0;         ///< the root of the integral of its square
  double h1 = 0;         ///< the same for its gradient (the H1 seminorm)
  int exact_degree = 0;  ///< the quadrature rule is exact for polynomials of this degree in xi
};

/// The difference between a component of a field and a function, in the document's units. The function's gradient
/// is taken by differences of order 6 over a thousandth of an element, good to some 1e-11 of the function.
///
/// Shapes      exact: a function, or none, for each face
/// Requires    a field of that name with that component
/// Throws      InputError where the function is not finite
ErrorNorms error_norms(const Mesh& mesh, const std::string& field, std::span<const std::optional<Coefficient>> exact,
                       int component = 0);

}  // namespace pliant
