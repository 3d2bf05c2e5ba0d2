// lib/pliant/fem/interpolate.cpp: values at the nodes of a lattice in each element.
#include "pliant/fem/interpolate.h"

#include <array>

#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"

namespace pliant {

std::vector<double> interpolate(const Space& space, const Mesh& mesh, const Configuration& at,
                                const CoefficientOfFace& coefficient) {
  const NetLayout& layout = mesh.layout();
  const int p = mesh.degree();
  const std::size_t n = index(layout.size());
  const double unit = mesh.boundary().unit;
  std::vector<double> net(2 * n), values(n), polygon(index(p) + 1);
  std::vector<double> sums(index(space.size()), 0.0), last(index(space.size()), 0.0);
  std::vector<int> counts(index(space.size()), 0), faces(index(space.size()), none);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    const FaceId face = mesh.face(t);
    std::size_t k = 0;
    for (const PointId point : mesh.net(t)) {
      net[2 * k] = at.points[index(point)].x;
      net[2 * k + 1] = at.points[index(point)].y;
      ++k;
    }
    for (int i = 0; i < layout.size(); ++i) {
      const auto& exponents = layout.exponents(i);
      Barycentric xi{};
      for (std::size_t c = 0; c < 3; ++c) xi[c] = static_cast<double>(exponents[c]) / p;
      std::array<double, 2> x;
      evaluate_net(p, 2, net, xi, x);
      values[index(i)] = evaluate_at(coefficient(face), {mesh, t, xi, {unit * x[0], unit * x[1]}, at.time});
    }
    for (int e = 0; e < 3; ++e) {
      for (int i = 0; i <= p; ++i) polygon[index(i)] = values[index(layout.edge_index(e, i))];
      interpolate_polygon(p, 1, polygon);
      for (int i = 1; i < p; ++i) values[index(layout.edge_index(e, i))] = polygon[index(i)];
    }
    if (p > 2) interpolate_interior(p, 1, values);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t unknown = index(space.of(t)[i]);
      if (faces[unknown] == face || (counts[unknown] > 0 && last[unknown] == values[i])) continue;
      faces[unknown] = face;  // elements of two faces by turns count more than once, which does no harm
      last[unknown] = values[i];
      sums[unknown] += values[i];
      ++counts[unknown];
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
  return sums;
}

void interpolate_edge(const Mesh& mesh, const Configuration& at, HalfEdgeId h,
                      std::span<const Coefficient* const> coefficients, std::span<double> values) {
  const int p = mesh.degree();
  const double unit = mesh.boundary().unit;
  std::array<double, 2 * (max_degree + 1)> polygon;
  const auto rows = std::span(polygon).first(2 * (index(p) + 1));
  for (int k = 0; k <= p; ++k) {
    const Point& place = at.points[index(mesh.edge_point(h, k))];
    rows[2 * index(k)] = place.x;
    rows[2 * index(k) + 1] = place.y;
  }
  for (int k = 0; k <= p; ++k) {
    const double s = static_cast<double>(k) / p;
    Barycentric xi{0, 0, 0};
    xi[index(edge_of(h))] = 1 - s;
    xi[index(edge_of(next(h)))] = s;
    std::array<double, 2> x;
    evaluate_polygon(p, 2, rows, s, x);
    const CoefficientPoint there{mesh, triangle_of(h), xi, {unit * x[0], unit * x[1]}, at.time};
    for (std::size_t c = 0; c < coefficients.size(); ++c)
      values[index(k) * coefficients.size() + c] = evaluate_at(*coefficients[c], there);
  }
  interpolate_polygon(p, static_cast<int>(coefficients.size()), values);
}

}  // namespace pliant
