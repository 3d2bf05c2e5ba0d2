// lib/pliant/improve/global/wanted_shapes.h: the triangles that the elements of a mesh should be like.
#pragma once
#include <span>
#include <vector>

#include "pliant/improve/global/deformation_energy.h"
#include "pliant/improve/global/free_points.h"

namespace pliant {

/// For each of these elements the straight triangle on its vertices, or, where that is inverted or too flat for any
/// element to be like it, a thicker one. With `equilateral` an equilateral one of the element's area, or, where that is
/// small against those beside it, of a share of theirs.
std::vector<WantedShape> wanted_shapes(const FreePoints& points, std::span<const TriangleId> elements,
                                       bool equilateral);

}  // namespace pliant
