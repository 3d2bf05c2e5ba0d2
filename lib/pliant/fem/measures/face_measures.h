// lib/pliant/fem/measures/face_measures.h: areas, centres, integrals and bounds over faces.
#pragma once
#include "pliant/fem/measures/mesh_function.h"

namespace pliant {

/// In place of a face: all of them.
inline constexpr FaceId every_face = none;

struct AreaAndCentre {
  double area = 0;
  Point centre;  ///< of mass; where the area is 0 no point
};

/// Both exact to rounding; all functions here answer in the document's units.
AreaAndCentre measure_area(const Mesh& mesh, FaceId face);

/// The integral of a function over a face. It is exact to rounding for fields, for products of two of them, and for
/// polynomials of such a degree in xi; of other expressions the rule takes all polynomials of degree 4p + 4 (at most
/// 40) in xi.
/// Throws      InputError where an expression is not finite
double integrate(MeshFunction& function, const Mesh& mesh, FaceId face);

struct Range {
  double least, greatest;
};
/// The bounds of a field over a face: all values are within, and they are missed by no more than 1e-9 of their
/// difference. Empty where the face has no elements.   Requires    a field
std::optional<Range> bounds(MeshFunction& field, const Mesh& mesh, FaceId face);

}  // namespace pliant
