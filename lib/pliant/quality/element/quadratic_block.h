// lib/pliant/quality/element/quadratic_block.h: many quadratic elements measured side by side (private to this layer).
#pragma once
#include <array>
#include <cstddef>

namespace pliant {

/// The measures of element_measures.h, to the last bit, for elements that are valid and nearly straight, as most are:
/// there every bound holds at once, nothing is subdivided, and the same operations run on several elements together.
struct QuadraticBlock {
  static constexpr std::size_t size = 64;
  using Column = std::array<double, size>;

  std::array<Column, 6> x, y;  ///< the control points, in the order of NetLayout

  Column jacobian, jacobian_max, scaled_jacobian, shape, logical_tau, control_tau, distortion, area;
  Column angle_sine, angle_cosine, turn_sine, turn_cosine;  ///< of the angles, up to a factor
  std::array<Column, 3> edge_length;
  std::array<bool, size> settled;  ///< elsewhere nothing of the above holds, and the element is measured by itself
};
void measure_block(QuadraticBlock& block, double jacobian_width);

}  // namespace pliant
