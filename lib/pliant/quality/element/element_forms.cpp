// lib/pliant/quality/element/element_forms.cpp: products of polynomials in Bernstein form, by a table of their terms.
#include "pliant/quality/element/element_forms.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/jacobian_terms.h"

namespace pliant {
namespace {

struct FormTable {
  std::vector<std::array<int, 3>> triangles;
  const JacobianTerms* products;  ///< the terms of the product of two polynomials of degree p - 1, as det J is one
};

FormTable build_table(int degree) {
  const NetLayout& net = NetLayout::of(degree);
  const JacobianTerms& products = JacobianTerms::of(degree);
  FormTable table{products.partials, &products};
  if (degree < 2) return table;
  const NetLayout& inverted = NetLayout::of(degree - 2);
  for (int m = 0; m < inverted.size(); ++m) {
    const auto [i, j, k] = inverted.exponents(m);
    table.triangles.push_back({net.index(i, j + 1), net.index(i + 1, j), net.index(i + 1, j + 1)});
  }
  return table;
}

const FormTable& table_of(int degree) {
  static const std::vector<FormTable> all = [] {
    std::vector<FormTable> tables;
    for (int p = 1; p <= max_degree; ++p) tables.push_back(build_table(p));
    return tables;
  }();
  assert(1 <= degree && degree <= max_degree);
  return all[index(degree - 1)];
}

/// The greatest power of two not above x > 0, but at least 2^-1022, lest its inverse overflow.
double power_of_two(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000U;
  return bits == 0 ? 0x1p-1022 : std::bit_cast<double>(bits);
}

/// The sums of the table for p = 2, written out: first the coefficients at the corners, then those of the edges.
void quadratic_forms(const Vector* along_2, const Vector* along_3, ElementForms& forms) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Vector &a = along_2[i], &b = along_3[i], &c = along_2[j], &d = along_3[j];
    forms.jacobian[i] = 4 * cross(a, b);
    forms.squares[i] = 4 * (dot(a, a - b) + dot(b, b));
    forms.jacobian[3 + i] = 2 * (cross(a, d) + cross(c, b));
    forms.squares[3 + i] = 2 * (2 * dot(a, c) - dot(a, d) - dot(c, b) + 2 * dot(b, d));
  }
}

}  // namespace

std::span<const std::array<int, 3>> control_triangles(int degree) { return table_of(degree).triangles; }

double ElementForms::mean_jacobian() const {
  return std::accumulate(jacobian.begin(), jacobian.begin() + size(), 0.0) / size();
}

void element_forms(int degree, std::span<const Point> net, ElementForms& forms) {
  const FormTable& table = table_of(degree);
  const std::size_t partials = index(net_size(degree - 1));
  std::array<Vector, net_size(max_degree - 1)> along_2, along_3;
  double greatest = 0;
  for (std::size_t m = 0; m < partials; ++m) {
    const auto [first, second, third] = table.triangles[m];
    along_2[m] = net[index(second)] - net[index(first)];
    along_3[m] = net[index(third)] - net[index(first)];
    for (const Vector& v : {along_2[m], along_3[m]}) greatest = std::max({greatest, std::fabs(v.x), std::fabs(v.y)});
  }
  forms.degree = 2 * (degree - 1);
  forms.is_point = greatest == 0;
  forms.is_finite = std::isfinite(greatest);
  if (!forms.is_finite) return;
  forms.unit = forms.is_point ? 1 : power_of_two(greatest);
  const double scale = 1 / forms.unit;
  for (std::size_t m = 0; m < partials; ++m) {
    along_2[m] *= scale;
    along_3[m] *= scale;
  }
  // Components are below 2, so each product is below 16. A coefficient is a sum of at most `most_terms` products whose
  // weights sum to p^2; each product carries about ten roundings of 2^-53.
  forms.error = (table.products->most_terms + 10) * 0x1p-53 * 16 * degree * degree;
  if (degree == 2) return quadratic_forms(along_2.data(), along_3.data(), forms);
  std::fill_n(forms.jacobian.begin(), forms.size(), 0.0);
  std::fill_n(forms.squares.begin(), forms.size(), 0.0);
  for (const JacobianTerm& term : table.products->terms) {
    const Vector &a = along_2[index(term.i)], &b = along_3[index(term.j)];
    const Vector &c = along_2[index(term.j)], &d = along_3[index(term.i)];
    forms.jacobian[index(term.target)] += term.weight * cross(a, b);
    forms.squares[index(term.target)] += term.weight * (dot(a, c - b) + dot(d, b));
  }
}

}  // namespace pliant
