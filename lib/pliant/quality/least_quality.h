// lib/pliant/quality/least_quality.h: the least shape and scaled Jacobian of elements, which passes may hold.
#pragma once
#include <cmath>
#include <span>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The least curved shape and the least scaled Jacobian of some elements, as the quality report has them to the last
/// bit; infinite of none, -1 where the numbers overflow.
struct LeastQuality {
  double shape = HUGE_VAL, scaled_jacobian = HUGE_VAL;

  bool is_at_least(const LeastQuality& floor) const {
    return shape >= floor.shape && scaled_jacobian >= floor.scaled_jacobian;
  }
};
LeastQuality least_of(const LeastQuality& a, const LeastQuality& b);

LeastQuality element_quality(int degree, std::span<const Point> net);
LeastQuality element_quality(const Mesh& mesh, TriangleId t);
LeastQuality least_quality(const Mesh& mesh, std::span<const TriangleId> elements);

/// Of all elements of the mesh. Where `poor` are the worst of them it takes no longer than to look at each once: the
/// coefficients of det J show that most elements are better.
LeastQuality least_quality_of_mesh(const Mesh& mesh, std::span<const TriangleId> poor = {});

}  // namespace pliant
