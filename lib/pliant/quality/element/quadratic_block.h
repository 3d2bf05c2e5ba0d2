// lib/pliant/quality/element/quadratic_block.h: many quadratic elements measured side by side (private to this layer).
#pragma once
#include <array>
#include <cstddef>

namespace pliant {

/// The measures of element_measures.h, bit for bit, for many quadratic elements together. It works for elements that
/// are valid and nearly straight, as most are: their bounds are good enough without subdivision, so the same operations
/// serve all of them.
struct QuadraticBlock {
  static constexpr std::size_t size = 64;
  using Column = std::array<double, size>;

  std::array<Column, 6> x, y;  ///< the control points, in the order of NetLayout

  Column jacobian, jacobian_max, scaled_jacobian, shape, logical_tau, control_tau, distortion, area;
  Column angle_sine, angle_cosine, turn_sine, turn_cosine;  ///< least angle and turning, up to a common factor
  std::array<Column, 3> edge_length;
  std::array<bool, size> settled;  ///< false: the measures above do not hold, and the element must be measured alone
};
/// Fills in the measures of the elements whose control points are in x and y.
void measure_block(QuadraticBlock& block, double jacobian_width);

}  // namespace pliant
