// lib/pliant/quality/least_quality.h: the least shape and scaled Jacobian of elements, which passes may have to keep.
#pragma once
#include <cmath>
#include <span>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The least curved shape and the least scaled Jacobian of some elements: the same numbers as in the quality report,
/// bit for bit. Infinite if there are no elements; -1 if numbers overflow.
struct LeastQuality {
  double shape = HUGE_VAL, scaled_jacobian = HUGE_VAL;

  bool is_at_least(const LeastQuality& floor) const {
    return shape >= floor.shape && scaled_jacobian >= floor.scaled_jacobian;
  }
};
/// The smaller of the two in each measure.
LeastQuality least_of(const LeastQuality& a, const LeastQuality& b);

LeastQuality element_quality(int degree, std::span<const Point> net);
LeastQuality element_quality(const Mesh& mesh, TriangleId t);
/// Over these elements; those that are not alive are left out.
LeastQuality least_quality(const Mesh& mesh, std::span<const TriangleId> elements);

/// Over all elements of the mesh. It is fast if `poor` contains the worst of them, which are measured first: then the
/// coefficients of det J show that most other elements are better.
LeastQuality least_quality_of_mesh(const Mesh& mesh, std::span<const TriangleId> poor = {});

/// The least angle of the straight triangles on the corners, in degrees; 60 if there are no elements.
///
/// Complexity  O(mesh)
double least_logical_angle(const Mesh& mesh);

}  // namespace pliant
