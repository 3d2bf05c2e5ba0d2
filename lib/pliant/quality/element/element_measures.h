// lib/pliant/quality/element/element_measures.h: all that the report says of single elements (private to this layer).
#pragma once
#include <array>
#include <functional>
#include <span>

#include "pliant/geometry/validity/validity.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// Angles in degrees. NaN: does not exist, or overflows.
struct ElementMeasures {
  Validity validity;
  double jacobian, jacobian_max;  ///< guaranteed bounds of min and max det J, from below and from above
  double scaled_jacobian, shape, logical_tau, control_tau, distortion, logical_angle, turning_angle, area;
  std::array<double, 3> edge_length;  ///< arc lengths of edges 12, 23, 31
  double shortest_edge, longest_edge;
};
/// Requires    net: net_size(degree) finite points in the order of NetLayout
ElementMeasures measure_element(const BoundaryComplex& boundary, int degree, std::span<const Point> net,
                                double jacobian_width);

/// The same of all these elements: `take` gets some of them at a time, in order, and the place of their first.
void measure_elements(const MeshData& data, std::span<const TriangleId> elements, double jacobian_width,
                      const std::function<void(std::size_t first, std::span<const ElementMeasures>)>& take);

}  // namespace pliant
