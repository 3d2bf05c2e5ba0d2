// tests/support/bernstein_matrices.h: mass and stiffness matrices of a mesh, assembled in the plainest way.
#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "pliant/fem/csr_matrix.h"
#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/quadrature.h"
#include "pliant/mesh/mesh.h"

namespace pliant::samples {

struct MassAndStiffness {
  CsrMatrix mass, stiffness;
};

/// The pattern of a mesh's own basis: two control points of one triangle have an entry.
inline std::shared_ptr<const CsrPattern> pattern_of(const Mesh& mesh) {
  const std::size_t n = index(mesh.point_slots());
  std::vector<int> starts(n + 1, 0), triangles;
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (const PointId p : mesh.net(t)) ++starts[index(p) + 1];
  for (std::size_t i = 0; i < n; ++i) starts[i + 1] += starts[i];
  triangles.resize(index(starts[n]));
  std::vector<int> next(starts.begin(), starts.end() - 1);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t)
    for (const PointId p : mesh.net(t)) triangles[index(next[index(p)]++)] = t;
  const auto pattern = std::make_shared<CsrPattern>();
  std::vector<int> row;
  for (std::size_t i = 0; i < n; ++i) {
    row.clear();
    for (int k = starts[i]; k < starts[i + 1]; ++k)
      for (const PointId p : mesh.net(triangles[index(k)])) row.push_back(p);
    std::ranges::sort(row);
    row.erase(std::unique(row.begin(), row.end()), row.end());
    pattern->columns.insert(pattern->columns.end(), row.begin(), row.end());
    pattern->starts.push_back(static_cast<int>(pattern->columns.size()));
  }
  return pattern;
}

/// The basis functions and their derivatives along xi2 and xi3 at one place.
struct BasisAt {
  std::vector<double> value, along_2, along_3;

  BasisAt(int p, const Barycentric& xi) : value(index(net_size(p))), along_2(value), along_3(value) {
    bernstein_basis(p, xi, value);
    std::vector<double> lower(index(net_size(p - 1)));
    bernstein_basis(p - 1, xi, lower);
    const NetLayout &own = NetLayout::of(p), &below = NetLayout::of(p - 1);
    for (int m = 0; m < own.size(); ++m) {
      const auto [i, j, k] = own.exponents(m);
      const double along_1 = i > 0 ? lower[index(below.index(i - 1, j))] : 0;
      along_2[index(m)] = p * ((j > 0 ? lower[index(below.index(i, j - 1))] : 0) - along_1);
      along_3[index(m)] = p * ((k > 0 ? lower[index(below.index(i, j))] : 0) - along_1);
    }
  }
};

/// ∫ u v and ∫ d ∇u·∇v, with d constant on each triangle (1 where `diffusivity` is empty).
inline MassAndStiffness mass_and_stiffness(const Mesh& mesh, const std::vector<double>& diffusivity = {}) {
  const int p = mesh.degree();
  const std::size_t size = index(mesh.net_size());
  MassAndStiffness result;
  result.mass.pattern = result.stiffness.pattern = pattern_of(mesh);
  result.mass.values.assign(result.mass.pattern->columns.size(), 0);
  result.stiffness.values = result.mass.values;
  const auto rule = triangle_rule(4 * p - 2);
  std::vector<BasisAt> basis;
  for (const TriangleNode& node : rule) basis.emplace_back(p, node.xi);
  std::vector<Point> net(size);
  std::vector<double> mass(size * size), stiffness(size * size);
  std::vector<Vector> gradient(size);
  for (TriangleId t = 0; t < mesh.triangle_slots(); ++t) {
    mesh.gather_points(t, net);
    std::ranges::fill(mass, 0);
    std::ranges::fill(stiffness, 0);
    for (std::size_t q = 0; q < rule.size(); ++q) {
      const BasisAt& b = basis[q];
      Vector along_2, along_3;
      for (std::size_t m = 0; m < size; ++m) along_2 += b.along_2[m] * net[m], along_3 += b.along_3[m] * net[m];
      const double det = cross(along_2, along_3), weight = rule[q].weight * det;
      for (std::size_t m = 0; m < size; ++m)
        gradient[m] = Vector{along_3.y * b.along_2[m] - along_2.y * b.along_3[m],
                             along_2.x * b.along_3[m] - along_3.x * b.along_2[m]} /
                      det;
      for (std::size_t m = 0; m < size; ++m)
        for (std::size_t k = 0; k < size; ++k) {
          mass[m * size + k] += weight * (b.value[m] * b.value[k]);
          stiffness[m * size + k] += weight * dot(gradient[m], gradient[k]);
        }
    }
    const double d = diffusivity.empty() ? 1 : diffusivity[index(t)];
    const auto points = mesh.net(t);
    for (std::size_t m = 0; m < size; ++m)
      for (std::size_t k = 0; k < size; ++k) {
        const std::size_t place = index(result.mass.pattern->find(points[m], points[k]));
        result.mass.values[place] += mass[m * size + k];
        result.stiffness.values[place] += d * stiffness[m * size + k];
      }
  }
  return result;
}

/// a + factor * b, where both have the same pattern.
inline CsrMatrix sum(const CsrMatrix& a, double factor, const CsrMatrix& b) {
  CsrMatrix result = a;
  for (std::size_t k = 0; k < result.values.size(); ++k) result.values[k] += factor * b.values[k];
  return result;
}

/// Makes row and column i of the matrix those of the identity, for each i that is fixed.
inline void fix(CsrMatrix& a, const std::vector<bool>& fixed) {
  const CsrPattern& pattern = *a.pattern;
  for (int i = 0; i < a.rows(); ++i)
    for (int k = pattern.starts[index(i)]; k < pattern.starts[index(i) + 1]; ++k) {
      const int j = pattern.columns[index(k)];
      if (fixed[index(i)] || fixed[index(j)]) a.values[index(k)] = i == j ? 1 : 0;
    }
}

/// Which control points are on constrained edges.
inline std::vector<bool> on_curves(const Mesh& mesh) {
  std::vector<bool> result(index(mesh.point_slots()), false);
  for (const HalfEdgeId h : mesh.half_edges())
    if (mesh.is_constrained(h))
      for (int k = 0; k <= mesh.degree(); ++k) result[index(mesh.edge_point(h, k))] = true;
  return result;
}

}  // namespace pliant::samples
