// lib/pliant/quality/element/element_measures.cpp: all measures of an element from its forms, which are computed once.
#include "pliant/quality/element/element_measures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "pliant/geometry/index.h"
#include "pliant/geometry/linear_triangle.h"
#include "pliant/geometry/net_layout.h"
#include "pliant/mesh/check_mesh.h"
#include "pliant/quality/edge_curves.h"
#include "pliant/quality/element/element_forms.h"
#include "pliant/quality/element/element_quality.h"
#include "pliant/quality/element/quadratic_block.h"

namespace pliant {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// Asks for control points before they are needed, since they lie scattered in memory.
void fetch([[maybe_unused]] const MeshData& data, [[maybe_unused]] std::span<const TriangleId> elements) {
#ifdef __GNUC__
  for (const TriangleId t : elements)
    for (std::size_t k = 0; k < 6; ++k) __builtin_prefetch(&data.points[index(data.triangles[index(t) * 6 + k])]);
#endif
}

void gather(const MeshData& data, std::span<const TriangleId> elements, QuadraticBlock& block) {
  for (std::size_t l = 0; l < elements.size(); ++l) {
    const PointId* ids = &data.triangles[index(elements[l]) * 6];
    for (std::size_t k = 0; k < 6; ++k) {
      const Point& p = data.points[index(ids[k])];
      block.x[k][l] = p.x;
      block.y[k][l] = p.y;
    }
  }
}

void find_extreme_edges(ElementMeasures& measures) {
  measures.shortest_edge = *std::ranges::min_element(measures.edge_length);
  measures.longest_edge = *std::ranges::max_element(measures.edge_length);
}

/// The measures of the l-th element of a block.
ElementMeasures lane(const QuadraticBlock& block, std::size_t l) {
  ElementMeasures measures{Validity::valid,
                           block.jacobian[l],
                           block.jacobian_max[l],
                           block.scaled_jacobian[l],
                           block.shape[l],
                           block.logical_tau[l],
                           block.control_tau[l],
                           block.distortion[l],
                           degrees * std::atan2(block.angle_sine[l], block.angle_cosine[l]),
                           degrees * turn_of(block.turn_sine[l], block.turn_cosine[l]),
                           block.area[l],
                           {block.edge_length[0][l], block.edge_length[1][l], block.edge_length[2][l]},
                           0,
                           0};
  find_extreme_edges(measures);
  return measures;
}

}  // namespace

ElementMeasures measure_element(const BoundaryComplex& boundary, int degree, std::span<const Point> net,
                                double jacobian_width) {
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
  for (int e = 0; e < 3; ++e) measures.edge_length[index(e)] = edge_length(degree, net, e);
  find_extreme_edges(measures);
  return measures;
}

void measure_elements(const MeshData& data, std::span<const TriangleId> elements, double jacobian_width,
                      const std::function<void(std::size_t first, std::span<const ElementMeasures>)>& take) {
  const auto n = index(net_size(data.degree));
  std::array<Point, net_size(max_degree)> storage;
  const std::span<Point> net = std::span(storage).first(n);
  const auto measure_alone = [&](TriangleId t) {
    const PointId* ids = &data.triangles[index(t) * n];
    for (std::size_t k = 0; k < n; ++k) net[k] = data.points[index(ids[k])];
    return measure_element(data.boundary, data.degree, net, jacobian_width);
  };
  constexpr std::size_t size = QuadraticBlock::size;
  std::array<ElementMeasures, size> measures;
  QuadraticBlock block;
  for (std::size_t first = 0; first < elements.size(); first += size) {
    const auto some = elements.subspan(first, std::min(size, elements.size() - first));
    const bool together = data.degree == 2 && some.size() == size;
    if (together) {
      const auto left = elements.subspan(first + size);
      fetch(data, left.first(std::min(size, left.size())));
      gather(data, some, block);
      measure_block(block, jacobian_width);
    }
    for (std::size_t l = 0; l < some.size(); ++l)
      measures[l] = together && block.settled[l] ? lane(block, l) : measure_alone(some[l]);
    take(first, std::span(measures).first(some.size()));
  }
}

}  // namespace pliant
