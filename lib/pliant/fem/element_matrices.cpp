// lib/pliant/fem/element_matrices.cpp: sums of tabulated products, each with one factor of the element.
#include "pliant/fem/element_matrices.h"

#include <algorithm>
#include <vector>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"

namespace pliant {
namespace {

/// sums = the sum over r of factors[r] * rows[r], where rows have `count` entries. With a count known when compiled the
/// sums stay in registers.
template <std::size_t count>
void combine(std::span<const double> factors, const double* rows, double* sums) {
  double kept[count] = {};
  for (const double factor : factors) {
    for (std::size_t k = 0; k < count; ++k) kept[k] += factor * rows[k];
    rows += count;
  }
  std::copy(kept, kept + count, sums);
}

void combine(std::span<const double> factors, const std::vector<double>& rows, std::span<double> sums) {
  switch (sums.size()) {
    case 6:
      return combine<6>(factors, rows.data(), sums.data());
    case 21:
      return combine<21>(factors, rows.data(), sums.data());
    case 55:
      return combine<55>(factors, rows.data(), sums.data());
    default:
      break;
  }
  std::ranges::fill(sums, 0.0);
  const double* row = rows.data();
  for (const double factor : factors) {
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += factor * row[k];
    row += sums.size();
  }
}

/// Gradients are (D2 u2 + D3 u3) / det J with these two vectors.
struct Cofactors {
  Vector u2, u3;
};
Cofactors cofactors(const ElementMap& map, int q) {
  const Vector to_2 = map.along_2(q), to_3 = map.along_3(q);
  return {{to_3.y, -to_3.x}, {-to_2.y, to_2.x}};
}

constexpr std::size_t most_points = 512;  // of any rule

}  // namespace

void element_mass(const ElementMap& map, std::span<const double> factors, std::span<double> pairs) {
  std::array<double, most_points> scaled;
  const std::size_t m = index(map.points());
  for (std::size_t q = 0; q < m; ++q) scaled[q] = factors[q] * map.det(static_cast<int>(q));
  combine(std::span(scaled).first(m), map.table().masses, pairs);
}

void element_stiffness(const ElementMap& map, std::span<const SymmetricTensor> tensors, std::span<double> pairs) {
  std::array<double, 3 * most_points> scaled;
  for (int q = 0; q < map.points(); ++q) {
    const auto [u2, u3] = cofactors(map, q);
    const SymmetricTensor& k = tensors[index(q)];
    const Vector k2{k.xx * u2.x + k.xy * u2.y, k.xy * u2.x + k.yy * u2.y};
    const Vector k3{k.xx * u3.x + k.xy * u3.y, k.xy * u3.x + k.yy * u3.y};
    const double inverse = 1 / map.det(q);
    scaled[3 * index(q)] = dot(u2, k2) * inverse;
    scaled[3 * index(q) + 1] = dot(u2, k3) * inverse;
    scaled[3 * index(q) + 2] = dot(u3, k3) * inverse;
  }
  combine(std::span(scaled).first(3 * index(map.points())), map.table().gradients, pairs);
}

void element_convection(const ElementMap& map, std::span<const Vector> velocities, std::span<double> full) {
  std::ranges::fill(full, 0.0);
  const ElementTable& table = map.table();
  const std::size_t n = index(table.size);
  for (int q = 0; q < map.points(); ++q) {
    const auto [u2, u3] = cofactors(map, q);
    const double w = table.weights[index(q)];
    const double by_2 = w * dot(velocities[index(q)], u2), by_3 = w * dot(velocities[index(q)], u3);
    const auto b = table.values_at(q), d2 = table.along_2_at(q), d3 = table.along_3_at(q);
    for (std::size_t j = 0; j < n; ++j) {
      const double along = by_2 * d2[j] + by_3 * d3[j];
      for (std::size_t i = 0; i < n; ++i) full[i * n + j] += b[i] * along;
    }
  }
}

void element_divergence(const ElementMap& map, int pressure, std::span<double> along_x, std::span<double> along_y) {
  std::ranges::fill(along_x, 0.0);
  std::ranges::fill(along_y, 0.0);
  const ElementTable& table = map.table();
  const std::size_t n = index(table.size), rows = index(net_size(pressure));
  std::array<double, net_size(max_degree)> basis;
  for (int q = 0; q < map.points(); ++q) {
    bernstein_basis(pressure, table.xi[index(q)], std::span(basis).first(rows));
    const auto [u2, u3] = cofactors(map, q);
    const double w = table.weights[index(q)];
    const auto d2 = table.along_2_at(q), d3 = table.along_3_at(q);
    for (std::size_t j = 0; j < n; ++j) {
      const Vector gradient = w * (d2[j] * u2 + d3[j] * u3);  // times det J
      for (std::size_t i = 0; i < rows; ++i) {
        along_x[i * n + j] += basis[i] * gradient.x;
        along_y[i * n + j] += basis[i] * gradient.y;
      }
    }
  }
}

void element_load(const ElementMap& map, std::span<const double> factors, std::span<double> load) {
  std::ranges::fill(load, 0.0);
  for (int q = 0; q < map.points(); ++q) {
    const double f = factors[index(q)] * map.measure(q);
    const auto b = map.table().values_at(q);
    for (std::size_t i = 0; i < load.size(); ++i) load[i] += f * b[i];
  }
}

void unpack_pairs(int size, std::span<const double> pairs, std::span<double> full) {
  const std::size_t n = index(size);
  std::size_t k = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j, ++k) full[i * n + j] = full[j * n + i] = pairs[k];
}

void multiply_pairs(std::span<const double> pairs, std::span<const double> x, std::span<double> y) {
  std::ranges::fill(y, 0.0);
  std::size_t k = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j, ++k) {
      y[i] += pairs[k] * x[j];
      y[j] += pairs[k] * x[i];
    }
    y[i] += pairs[k++] * x[i];
  }
}

}  // namespace pliant
