// lib/pliant/geometry/validity/jacobian.cpp: det J as sums of cross products of differences of control points.
#include "pliant/geometry/validity/jacobian.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "pliant/geometry/bernstein.h"
#include "pliant/geometry/index.h"
#include "pliant/geometry/validity/jacobian_terms.h"

namespace pliant {
namespace {

JacobianTerms build_terms(int degree) {
  const NetLayout& net = NetLayout::of(degree);
  const NetLayout& partial = NetLayout::of(degree - 1);
  const NetLayout& product = NetLayout::of(jacobian_degree(degree));
  JacobianTerms result;
  result.degree = degree;
  for (int m = 0; m < partial.size(); ++m) {
    const auto [i, j, k] = partial.exponents(m);
    result.partials.push_back({net.index(i + 1, j), net.index(i, j + 1), net.index(i, j)});
  }
  std::vector<int> count(index(product.size()));
  for (int m = 0; m < partial.size(); ++m) {
    for (int n = 0; n < partial.size(); ++n) {
      const auto& e = partial.exponents(m);
      const auto& f = partial.exponents(n);
      const int target = product.index(e[0] + f[0], e[1] + f[1]);
      const double both = partial.multinomial(m) * partial.multinomial(n);
      result.terms.push_back({m, n, target, degree * degree * both / product.multinomial(target), both});
      result.most_terms = std::max(result.most_terms, ++count[index(target)]);
    }
  }
  std::stable_sort(result.terms.begin(), result.terms.end(),
                   [](const JacobianTerm& a, const JacobianTerm& b) { return a.target < b.target; });
  return result;
}

/// jacobian_net for p = 2, written out: the paper's vectors A and B at the three corners of the linear net, and their
/// products.
void quadratic_jacobian(std::span<const Point> net, std::span<double> out) {
  const Vector a[3] = {2 * (net[3] - net[0]), 2 * (net[1] - net[3]), 2 * (net[4] - net[5])};
  const Vector b[3] = {2 * (net[5] - net[0]), 2 * (net[4] - net[3]), 2 * (net[2] - net[5])};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    out[i] = cross(a[i], b[i]);
    out[3 + i] = (cross(a[i], b[j]) + cross(a[j], b[i])) / 2;
  }
}

}  // namespace

const JacobianTerms& JacobianTerms::of(int degree) {
  static const std::vector<JacobianTerms> all = [] {
    std::vector<JacobianTerms> degrees;
    for (int p = 1; p <= max_degree; ++p) degrees.push_back(build_terms(p));
    return degrees;
  }();
  assert(1 <= degree && degree <= max_degree);
  return all[index(degree - 1)];
}

void partial_differences(const JacobianTerms& terms, std::span<const Point> net, std::span<Vector> along_2,
                         std::span<Vector> along_3) {
  for (std::size_t m = 0; m < terms.partials.size(); ++m) {
    const auto [first, second, third] = terms.partials[m];
    along_2[m] = net[index(second)] - net[index(first)];
    along_3[m] = net[index(third)] - net[index(first)];
  }
}

void jacobian_net(int degree, std::span<const Point> net, std::span<double> out) {
  const int size = net_size(jacobian_degree(degree));
  assert(net.size() >= index(net_size(degree)) && out.size() >= index(size));
  if (degree == 1) {
    out[0] = cross(net[1] - net[0], net[2] - net[0]);
    return;
  }
  if (degree == 2) return quadratic_jacobian(net, out);
  const JacobianTerms& terms = JacobianTerms::of(degree);
  std::array<Vector, max_partials> along_2;
  std::array<Vector, max_partials> along_3;
  partial_differences(terms, net, along_2, along_3);
  std::fill_n(out.begin(), size, 0.0);
  for (const JacobianTerm& term : terms.terms)
    out[index(term.target)] += term.weight * cross(along_2[index(term.i)], along_3[index(term.j)]);
}

double jacobian_at(int degree, std::span<const Point> net, const Barycentric& xi) {
  assert(net.size() >= index(net_size(degree)));
  const JacobianTerms& terms = JacobianTerms::of(degree);
  std::array<double, max_partials> basis;
  bernstein_basis(degree - 1, xi, basis);
  Vector along_2;
  Vector along_3;
  for (std::size_t m = 0; m < terms.partials.size(); ++m) {
    const auto [first, second, third] = terms.partials[m];
    along_2 += basis[m] * (net[index(second)] - net[index(first)]);
    along_3 += basis[m] * (net[index(third)] - net[index(first)]);
  }
  return degree * degree * cross(along_2, along_3);
}

double element_area(int degree, std::span<const Point> net) {
  std::array<double, max_jacobian_size> coefficients;
  jacobian_net(degree, net, coefficients);
  return integrate_triangle(jacobian_degree(degree), coefficients);
}

}  // namespace pliant
