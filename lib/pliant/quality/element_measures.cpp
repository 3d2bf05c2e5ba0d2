#include "pliant/quality/element_measures.h"  // lib/pliant/quality/element_measures.cpp: each from the forms, computed once

#include <numbers>

#include "pliant/geometry/linear_triangle.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/quality/element_forms.h"
#include "pliant/quality/element_quality.h"

namespace pliant {

ElementMeasures measure_element(const BoundaryComplex& boundary, int degree, std::span<const Point> net,
                                double jacobian_width) {
  constexpr double degrees = 180 / std::numbers::pi;
  ElementForms forms;
  element_forms(degree, net, forms);
  ElementMeasures measures;
  measures.validity = certify_element(boundary, degree, net);
  const FormRange range = jacobian_range(forms, jacobian_width);
  measures.jacobian = forms.unscaled(range.least.lower);
  measures.jacobian_max = forms.unscaled(range.greatest.upper);
  measures.scaled_jacobian = scaled_jacobian(forms, range);
  measures.shape = curved_shape(forms);
  measures.logical_tau = triangle_shape(net[0], net[1], net[2]);
  measures.control_tau = control_shape(degree, net);
  measures.distortion = distortion(forms);
  measures.logical_angle = degrees * least_angle(net[0], net[1], net[2]);
  measures.turning_angle = degrees * element_turning(degree, net);
  measures.area = forms.unscaled(forms.mean_jacobian()) / 2;
  return measures;
}

}  // namespace pliant
