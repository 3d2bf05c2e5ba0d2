// lib/pliant/ops/even_jacobian.h: a step that moves control points so that det J comes near to a target.
#pragma once
#include <span>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The Bernstein coefficients of det J of each element, divided by the element's target.
///
/// Shapes      targets: one for each element; ratios: net_size(2 (p - 1)) for each element, one element after the other
void jacobian_ratios(const Mesh& mesh, std::span<const TriangleId> elements, std::span<const double> targets,
                     std::span<double> ratios);

/// Moves all the points at once by a Gauss-Newton step towards the least sum of weight (ratio - 1)^2; a small term for
/// how far the points go is added. `part` is how much of the step is gone; it is halved a few times until the sum
/// falls. True if the sum fell; otherwise the points are where they were, but for rounding. The ratios are affine in
/// each point, so differences give their derivatives exactly.
///
/// Shapes      targets: one for each element; weights: one for each ratio, or empty (all are 1)
/// Complexity  O(points^2 ratios); memory is reused from call to call
bool step_to_even_jacobian(Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> points,
                           std::span<const double> targets, std::span<const double> weights, double part = 1);

}  // namespace pliant
