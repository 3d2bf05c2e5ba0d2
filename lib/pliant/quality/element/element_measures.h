// lib/pliant/quality/element/element_measures.h: all measures of single elements in the report (private to this layer).
#pragma once
#include <array>
#include <functional>
#include <span>

#include "pliant/geometry/validity/validity.h"
#include "pliant/mesh/mesh_data.h"

namespace pliant {

/// All measures of one element. Angles are in degrees. NaN if a measure does not exist, or overflows.
struct ElementMeasures {
  Validity validity;
  double jacobian, jacobian_max;  ///< guaranteed: min det J is not below the first, max det J not above the second
  double scaled_jacobian, shape, logical_tau, control_tau, distortion, logical_angle, turning_angle, area;
  std::array<double, 3> edge_length;  ///< arc lengths of edges 12, 23, 31
  double shortest_edge, longest_edge;
};
/// Shapes      net: net_size(degree) finite points in the order of NetLayout
ElementMeasures measure_element(const BoundaryComplex& boundary, int degree, std::span<const Point> net,
                                double jacobian_width);

/// The same for many elements. `take` gets the measures of some elements at a time, in order; `first` is the position
/// of the first of them in `elements`.
void measure_elements(const MeshData& data, std::span<const TriangleId> elements, double jacobian_width,
                      const std::function<void(std::size_t first, std::span<const ElementMeasures>)>& take);

}  // namespace pliant
