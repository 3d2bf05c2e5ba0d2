#pragma once  // lib/pliant/quality/element_measures.h: all that the report says of one element (private to this layer)
#include <span>

#include "pliant/boundary/boundary_complex.h"
#include "pliant/geometry/validity.h"

namespace pliant {

/// Angles in degrees. NaN: does not exist, or overflows.
struct ElementMeasures {
  Validity validity;
  double jacobian, jacobian_max;  ///< guaranteed bounds of min and max det J, from below and from above
  double scaled_jacobian, shape, logical_tau, control_tau, distortion, logical_angle, turning_angle, area;
};
/// Requires    net: net_size(degree) finite points in the order of NetLayout
ElementMeasures measure_element(const BoundaryComplex& boundary, int degree, std::span<const Point> net,
                                double jacobian_width);

}  // namespace pliant
