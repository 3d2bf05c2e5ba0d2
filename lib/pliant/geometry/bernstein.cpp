// lib/pliant/geometry/bernstein.cpp: products, integrals and derivatives by their definitions, with exact binomials.
#include "pliant/geometry/bernstein.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <mutex>
#include <numeric>
#include <vector>

#include "pliant/geometry/index.h"

namespace pliant {
namespace {

using Powers = std::array<double, max_net_degree + 1>;

Powers powers(double x, int degree) {
  Powers result;
  result[0] = 1;
  for (int n = 1; n <= degree; ++n) result[index(n)] = result[index(n - 1)] * x;
  return result;
}

/// Binomial coefficients (degree choose k). Every step is exact, because all products stay below 2^53.
Powers binomials(int degree) {
  assert(degree <= max_net_degree);
  Powers result;
  result[0] = 1;
  for (int k = 1; k <= degree; ++k) result[index(k)] = result[index(k - 1)] * (degree + 1 - k) / k;
  return result;
}

std::vector<double> build_mass_matrix(int degree) {
  const NetLayout& layout = NetLayout::of(degree);
  const NetLayout& product = NetLayout::of(2 * degree);
  const double integral = 1.0 / ((2 * degree + 1) * (2 * degree + 2));  // of each basis function of degree 2p
  std::vector<double> matrix;
  for (int m = 0; m < layout.size(); ++m) {
    for (int n = 0; n < layout.size(); ++n) {
      const auto& a = layout.exponents(m);
      const auto& b = layout.exponents(n);
      const double ratio = layout.multinomial(m) * layout.multinomial(n);
      matrix.push_back(ratio / product.multinomial(product.index(a[0] + b[0], a[1] + b[1])) * integral);
    }
  }
  return matrix;
}

}  // namespace

void bernstein_basis(int degree, double s, std::span<double> values) {
  assert(degree <= max_net_degree && values.size() >= index(degree + 1));
  const Powers c = binomials(degree);
  const Powers a = powers(1 - s, degree);
  const Powers b = powers(s, degree);
  for (int k = 0; k <= degree; ++k) values[index(k)] = c[index(k)] * a[index(degree - k)] * b[index(k)];
}

void bernstein_basis(int degree, const Barycentric& xi, std::span<double> values) {
  const NetLayout& layout = NetLayout::of(degree);
  assert(values.size() >= index(layout.size()));
  const Powers a = powers(xi[0], degree);
  const Powers b = powers(xi[1], degree);
  const Powers c = powers(xi[2], degree);
  for (int n = 0; n < layout.size(); ++n) {
    const auto& e = layout.exponents(n);
    values[index(n)] = layout.multinomial(n) * a[index(e[0])] * b[index(e[1])] * c[index(e[2])];
  }
}

void multiply_segment(int p, std::span<const double> a, int q, std::span<const double> b, std::span<double> product) {
  assert(a.size() >= index(p + 1) && b.size() >= index(q + 1) && product.size() >= index(p + q + 1));
  assert(product.data() != a.data() && product.data() != b.data());
  const Powers binomials_a = binomials(p);
  const Powers binomials_b = binomials(q);
  const Powers binomials_product = binomials(p + q);
  std::fill_n(product.begin(), p + q + 1, 0.0);
  for (int m = 0; m <= p; ++m)
    for (int n = 0; n <= q; ++n)
      product[index(m + n)] += (binomials_a[index(m)] * a[index(m)]) * (binomials_b[index(n)] * b[index(n)]);
  for (int k = 0; k <= p + q; ++k) product[index(k)] /= binomials_product[index(k)];
}

void multiply_triangle(int p, std::span<const double> a, int q, std::span<const double> b, std::span<double> product) {
  const NetLayout& layout_a = NetLayout::of(p);
  const NetLayout& layout_b = NetLayout::of(q);
  const NetLayout& layout_product = NetLayout::of(p + q);
  assert(a.size() >= index(layout_a.size()) && b.size() >= index(layout_b.size()) &&
         product.size() >= index(layout_product.size()));
  assert(product.data() != a.data() && product.data() != b.data());
  std::fill_n(product.begin(), layout_product.size(), 0.0);
  for (int m = 0; m < layout_a.size(); ++m) {
    const auto& e = layout_a.exponents(m);
    const double factor = layout_a.multinomial(m) * a[index(m)];
    for (int n = 0; n < layout_b.size(); ++n) {
      const auto& f = layout_b.exponents(n);
      const int k = layout_product.index(e[0] + f[0], e[1] + f[1]);
      product[index(k)] += factor * (layout_b.multinomial(n) * b[index(n)]);
    }
  }
  for (int k = 0; k < layout_product.size(); ++k) product[index(k)] /= layout_product.multinomial(k);
}

double integrate_segment(int degree, std::span<const double> a) {
  assert(a.size() >= index(degree + 1));
  return std::accumulate(a.begin(), a.begin() + degree + 1, 0.0) / (degree + 1);
}

double integrate_triangle(int degree, std::span<const double> a) {
  assert(a.size() >= index(net_size(degree)));
  return std::accumulate(a.begin(), a.begin() + net_size(degree), 0.0) / (2 * net_size(degree));
}

void differentiate_segment(int degree, std::span<const double> a, std::span<double> derivative) {
  assert(degree >= 1 && a.size() >= index(degree + 1) && derivative.size() >= index(degree));
  for (int k = 0; k < degree; ++k) derivative[index(k)] = degree * (a[index(k + 1)] - a[index(k)]);
}

void differentiate_triangle(int degree, std::span<const double> a, std::span<double> along_2,
                            std::span<double> along_3) {
  const NetLayout& layout = NetLayout::of(degree);
  const NetLayout& lower = NetLayout::of(degree - 1);
  assert(a.size() >= index(layout.size()));
  assert(along_2.size() >= index(lower.size()) && along_3.size() >= index(lower.size()));
  assert(a.data() != along_2.data() && a.data() != along_3.data());
  for (int n = 0; n < lower.size(); ++n) {
    const auto [i, j, k] = lower.exponents(n);
    const double from = a[index(layout.index(i + 1, j))];
    along_2[index(n)] = degree * (a[index(layout.index(i, j + 1))] - from);
    along_3[index(n)] = degree * (a[index(layout.index(i, j))] - from);
  }
}

std::span<const double> mass_matrix(int degree) {
  constexpr int greatest = max_net_degree / 2;
  static std::array<std::once_flag, greatest + 1> built;
  static std::array<std::vector<double>, greatest + 1> matrices;
  assert(0 <= degree && degree <= greatest);
  std::call_once(built[index(degree)], [degree] { matrices[index(degree)] = build_mass_matrix(degree); });
  return matrices[index(degree)];
}

}  // namespace pliant
