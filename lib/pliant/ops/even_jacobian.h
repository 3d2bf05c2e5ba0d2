// lib/pliant/ops/even_jacobian.h: control points placed so that det J comes near to what it should be.
#pragma once
#include <span>

#include "pliant/mesh/mesh.h"

namespace pliant {

/// The Bernstein coefficients of det J of the elements, one element after the other, each divided by its element's
/// target: ratios has net_size(2 (p - 1)) places for each element.
void jacobian_ratios(const Mesh& mesh, std::span<const TriangleId> elements, std::span<const double> targets,
                     std::span<double> ratios);

/// One Gauss-Newton step over all the points at once towards the least sum of weight (ratio - 1)^2, and a little of how
/// far they go; halved until the sum falls, and without effect if it does not. The ratios are affine in each point, so
/// that their derivatives are exact differences.
///
/// Shapes      targets: one for each element; weights: as the ratios, or empty (all 1)
/// Complexity  O(points^2 ratios); memory is reused from call to call
bool step_to_even_jacobian(Mesh& mesh, std::span<const TriangleId> elements, std::span<const PointId> points,
                           std::span<const double> targets, std::span<const double> weights, double part = 1);

}  // namespace pliant
