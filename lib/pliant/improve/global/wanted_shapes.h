// lib/pliant/improve/global/wanted_shapes.h: the triangles that the elements of a mesh should be like.
#pragma once
#include <span>
#include <vector>

#include "pliant/improve/global/deformation_energy.h"
#include "pliant/improve/global/free_points.h"

namespace pliant {

/// For each of these elements its logical triangle, or a thicker one where that is inverted or too flat for any element
/// to be like it. With `equilateral`: an equilateral triangle of the mean area of the elements around it.
std::vector<WantedShape> wanted_shapes(const FreePoints& points, std::span<const TriangleId> elements,
                                       bool equilateral);

}  // namespace pliant
