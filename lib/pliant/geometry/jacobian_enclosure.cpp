#include "pliant/geometry/jacobian_enclosure.h"  // lib/pliant/geometry/jacobian_enclosure.cpp: coefficients and their error bound

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "pliant/geometry/jacobian.h"
#include "pliant/geometry/lattice.h"

namespace pliant {

double greatest_component(std::span<const Vector> a, std::span<const Vector> b) {
  double greatest = 0;
  for (const auto& vectors : {a, b})
    for (const Vector& v : vectors) greatest = std::max({greatest, std::fabs(v.x), std::fabs(v.y)});
  return greatest;
}

int normalise_differences(std::span<Vector> a, std::span<Vector> b, double greatest) {
  if (greatest == 0 || (greatest >= 0x1p-400 && greatest <= 0x1p400)) return 0;
  const int exponent = std::ilogb(greatest);
  for (const auto& vectors : {a, b})
    for (Vector& v : vectors) v = {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)};
  return exponent;
}

void enclose_jacobian(int degree, std::span<const Point> net, JacobianEnclosure& result) {
  const JacobianTerms& terms = JacobianTerms::of(degree);
  std::array<Vector, max_partials> storage_2;
  std::array<Vector, max_partials> storage_3;
  const std::span<Vector> along_2 = std::span(storage_2).first(terms.partials.size());
  const std::span<Vector> along_3 = std::span(storage_3).first(terms.partials.size());
  partial_differences(terms, net, along_2, along_3);

  const double greatest = greatest_component(along_2, along_3);
  result.degree = jacobian_degree(degree);
  result.is_finite = std::isfinite(greatest);
  if (!result.is_finite) return;
  result.exponent = 2 * normalise_differences(along_2, along_3, greatest);

  std::array<double, max_jacobian_size> sums{};
  std::array<double, max_jacobian_size> sizes{};
  const std::size_t size = static_cast<std::size_t>(net_size(result.degree));
  for (const JacobianTerm& term : terms.terms) {
    const Vector& a = along_2[static_cast<std::size_t>(term.i)];
    const Vector& b = along_3[static_cast<std::size_t>(term.j)];
    const double plus = a.x * b.y;
    const double minus = a.y * b.x;
    sums[static_cast<std::size_t>(term.target)] += term.weight * (plus - minus);
    sizes[static_cast<std::size_t>(term.target)] += term.weight * (std::fabs(plus) + std::fabs(minus));
  }
  const std::vector<int>& order = lattice_order(result.degree);
  result.greatest = 0;
  for (std::size_t n = 0; n < size; ++n) {
    result.coefficients[static_cast<std::size_t>(order[n])] = sums[n];
    result.greatest = std::max(result.greatest, std::fabs(sums[n]));
  }
  const double largest_size = *std::max_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(size));
  result.error = (terms.most_terms + 8) * unit_roundoff * largest_size + 0x1p-1000;
}

}  // namespace pliant
