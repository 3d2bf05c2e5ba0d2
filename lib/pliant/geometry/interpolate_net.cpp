// lib/pliant/geometry/interpolate_net.cpp: nodal values to control values (declared in control_net.h).
#include <Eigen/LU>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/control_net.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// The inverse of an n x n matrix, row-major.
std::vector<double> inverse(int n, const std::vector<double>& matrix) {
  // long double: the inverse's entries are doubles to the last bit or so.
  using Exact = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Rounded = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Exact exact = Eigen::Map<const Rounded>(matrix.data(), n, n).cast<long double>();
  std::vector<double> result(matrix.size());
  Eigen::Map<Rounded>(result.data(), n, n) = exact.inverse().cast<double>();
  return result;
}

/// The solution of the interpolation problem of one degree:
/// interior control values = inverse_matrix * (interior nodal values - boundary_matrix * boundary control values).
struct Collocation {
  int interior = 0, boundary = 0;       // how many control values of each kind
  std::vector<double> inverse_matrix;   // interior x interior
  std::vector<double> boundary_matrix;  // interior x boundary
};

/// `basis` holds one row for each interior node: the values there of all basis functions. The control values of the
/// first `boundary` basis functions are known.
Collocation collocate(int boundary, const std::vector<std::vector<double>>& basis) {
  Collocation result;
  result.boundary = boundary;
  result.interior = static_cast<int>(basis.size());
  std::vector<double> matrix;
  for (const std::vector<double>& row : basis) {
    result.boundary_matrix.insert(result.boundary_matrix.end(), row.begin(), row.begin() + boundary);
    matrix.insert(matrix.end(), row.begin() + boundary, row.end());
  }
  result.inverse_matrix = inverse(result.interior, matrix);
  return result;
}

/// The boundary of a polygon is its two ends: their basis functions come first in each row.
Collocation collocate_polygon(int degree) {
  std::vector<std::vector<double>> basis;
  for (int k = 1; k < degree; ++k) {
    std::vector<double> values(index(degree + 1));
    bernstein_basis(degree, static_cast<double>(k) / degree, values);
    std::vector<double> row{values.front(), values.back()};
    row.insert(row.end(), values.begin() + 1, values.end() - 1);
    basis.push_back(row);
  }
  return collocate(2, basis);
}

Collocation collocate_net(int degree) {
  const NetLayout& layout = NetLayout::of(degree);
  std::vector<std::vector<double>> basis;
  for (int n = layout.first_interior(); n < layout.size(); ++n) {
    const auto [i, j, k] = layout.exponents(n);
    std::vector<double> row(index(layout.size()));
    const double p = degree;
    bernstein_basis(degree, Barycentric{i / p, j / p, k / p}, row);
    basis.push_back(row);
  }
  return collocate(layout.first_interior(), basis);
}

template <Collocation build(int degree)>
const Collocation& collocation(int degree) {
  static std::array<std::once_flag, max_degree + 1> built;
  static std::array<Collocation, max_degree + 1> all;
  assert(2 <= degree && degree <= max_degree);
  std::call_once(built[index(degree)], [degree] { all[index(degree)] = build(degree); });
  return all[index(degree)];
}

}  // namespace

void interpolate_polygon(int degree, int width, std::span<double> polygon) {
  assert(polygon.size() >= index((degree + 1) * width));
  if (degree < 2) return;
  const Collocation& c = collocation<collocate_polygon>(degree);
  std::array<double, max_degree> rest;
  for (int x = 0; x < width; ++x) {
    // Only the departure from the chord is multiplied by the inverse. So a straight edge stays straight, and no digits
    // are lost far from the origin.
    const double first = polygon[index(x)];
    const double last = polygon[index(degree * width + x)];
    const auto chord = [&](int k) { return ((degree - k) * first + k * last) / degree; };
    for (int k = 1; k < degree; ++k) rest[index(k - 1)] = polygon[index(k * width + x)] - chord(k);
    for (int k = 1; k < degree; ++k) {
      double sum = 0;
      for (int n = 0; n < c.interior; ++n) sum += c.inverse_matrix[index((k - 1) * c.interior + n)] * rest[index(n)];
      polygon[index(k * width + x)] = chord(k) + sum;
    }
  }
}

void interpolate_interior(int degree, int width, std::span<double> net) {
  assert(net.size() >= index(net_size(degree) * width));
  if (degree < 3) return;
  const Collocation& c = collocation<collocate_net>(degree);
  const NetLayout& layout = NetLayout::of(degree);
  std::array<double, interior_size(max_degree)> rest;
  for (int x = 0; x < width; ++x) {
    // Only departures from the straight triangle are multiplied, for the reason given in interpolate_polygon.
    const auto value = [&](int n) -> double& { return net[index(n * width + x)]; };
    const auto flat = [&](int n) {
      const auto [i, j, k] = layout.exponents(n);
      return (i * value(0) + j * value(1) + k * value(2)) / degree;
    };
    for (int n = 0; n < c.interior; ++n) {
      double sum = value(c.boundary + n) - flat(c.boundary + n);
      for (int m = 3; m < c.boundary; ++m) sum -= c.boundary_matrix[index(n * c.boundary + m)] * (value(m) - flat(m));
      rest[index(n)] = sum;
    }
    for (int n = 0; n < c.interior; ++n) {
      double sum = 0;
      for (int m = 0; m < c.interior; ++m) sum += c.inverse_matrix[index(n * c.interior + m)] * rest[index(m)];
      value(c.boundary + n) = flat(c.boundary + n) + sum;
    }
  }
}

}  // namespace pliant
