// lib/pliant/geometry/validity/jacobian_enclosure.cpp: the coefficients of det J, fast, and their error bound.
#include "pliant/geometry/validity/jacobian_enclosure.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "pliant/geometry/index.h"
#include "pliant/geometry/lattice.h"
#include "pliant/geometry/validity/jacobian.h"

namespace pliant {
namespace {

/// The content of JacobianTerms in lattice order, in which a product of polynomials is a few plain convolutions of
/// rows.
struct RowTerms {
  struct Partial {
    std::size_t first, second, third;  // control points
    double multinomial;
  };
  std::vector<Partial> partials;  // in lattice order
  std::vector<double> weights;    // p^2 / multinomial, for each coefficient of det J in lattice order
  int most_terms = 0;

  static const RowTerms& of(int degree) {
    static const std::vector<RowTerms> all = [] {
      std::vector<RowTerms> degrees;
      for (int p = 1; p <= max_degree; ++p) degrees.push_back(build(p));
      return degrees;
    }();
    assert(1 <= degree && degree <= max_degree);
    return all[index(degree - 1)];
  }

 private:
  static RowTerms build(int degree) {
    const JacobianTerms& terms = JacobianTerms::of(degree);
    const NetLayout& partial = NetLayout::of(degree - 1);
    const NetLayout& product = NetLayout::of(jacobian_degree(degree));
    RowTerms result;
    result.most_terms = terms.most_terms;
    result.partials.resize(terms.partials.size());
    for (int m = 0; m < partial.size(); ++m) {
      const auto& [first, second, third] = terms.partials[index(m)];
      result.partials[index(lattice_order(partial.degree())[index(m)])] = {index(first), index(second), index(third),
                                                                           partial.multinomial(m)};
    }
    result.weights.resize(index(product.size()));
    for (int n = 0; n < product.size(); ++n)
      result.weights[index(lattice_order(product.degree())[index(n)])] = degree * degree / product.multinomial(n);
    return result;
  }
};

/// sums[i + j] = sum of cross(a[i], b[j]): the product of two polynomials of this degree. All coefficients, given and
/// computed, are multiplied by their multinomials.
template <int degree>
void multiply_rows(const Vector* a, const Vector* b, double* sums) {
  std::fill_n(sums, net_size(2 * degree), 0.0);
  for (int r = 0; r <= degree; ++r) {
    for (int k = 0; k <= r; ++k) {
      const Vector from = a[lattice_index(r, k)];
      for (int s = 0; s <= degree; ++s) {
        const Vector* with = b + lattice_index(s, 0);
        double* to = sums + lattice_index(r + s, k);
        for (int l = 0; l <= s; ++l) to[l] += cross(from, with[l]);
      }
    }
  }
}

/// At index n + m * size: the entry of the product to which the entries m and n of two nets of this degree add.
template <int degree>
constexpr auto product_targets() {
  std::array<std::size_t, static_cast<std::size_t>(net_size(degree) * net_size(degree))> targets{};
  std::size_t pair = 0;
  for (int r = 0; r <= degree; ++r)
    for (int k = 0; k <= r; ++k)
      for (int s = 0; s <= degree; ++s)
        for (int l = 0; l <= s; ++l) targets[pair++] = static_cast<std::size_t>(lattice_index(r + s, k + l));
  return targets;
}

/// Up to this degree of the element the products are written out without loops, which is faster while they are few.
/// (Debug builds check every access, and would take half a minute to compile the longer ones.)
#ifdef NDEBUG
constexpr int most_unrolled = 5;
#else
constexpr int most_unrolled = 3;
#endif

template <int degree>
void multiply_unrolled(const Vector* a, const Vector* b, double* sums) {
  constexpr auto target = product_targets<degree>();
  constexpr std::size_t count = net_size(degree);
  std::array<double, net_size(2 * degree)> local{};
  [&]<std::size_t... pair>(std::index_sequence<pair...>) {
    ((local[target[pair]] += cross(a[pair / count], b[pair % count])), ...);
  }
  (std::make_index_sequence<count * count>());
  std::copy(local.begin(), local.end(), sums);
}

template <int degree>
void enclose(std::span<const Point> net, JacobianEnclosure& result) {
  constexpr std::size_t count = net_size(degree - 1);
  const RowTerms& terms = RowTerms::of(degree);
  std::array<Vector, count> along_2;
  std::array<Vector, count> along_3;
  Vector greatest_2, greatest_3;  // the greatest |component| in x and in y
  const auto extend = [](Vector& greatest, const Vector& v) {
    greatest = {std::max(greatest.x, std::fabs(v.x)), std::max(greatest.y, std::fabs(v.y))};
  };
  for (std::size_t m = 0; m < count; ++m) {
    const RowTerms::Partial& partial = terms.partials[m];
    along_2[m] = net[partial.second] - net[partial.first];
    along_3[m] = net[partial.third] - net[partial.first];
    extend(greatest_2, along_2[m]);
    extend(greatest_3, along_3[m]);
  }
  const double greatest = std::max({greatest_2.x, greatest_2.y, greatest_3.x, greatest_3.y});
  result.degree = jacobian_degree(degree);
  result.is_finite = std::isfinite(greatest);
  if (!result.is_finite) return;
  const int exponent = normalise_differences(along_2, along_3, greatest);
  result.exponent = 2 * exponent;
  if (exponent != 0)
    for (Vector* v : {&greatest_2, &greatest_3}) *v = {std::ldexp(v->x, -exponent), std::ldexp(v->y, -exponent)};
  for (std::size_t m = 0; m < count; ++m) {
    along_2[m] *= terms.partials[m].multinomial;
    along_3[m] *= terms.partials[m].multinomial;
  }
  if constexpr (degree <= most_unrolled)
    multiply_unrolled<degree - 1>(along_2.data(), along_3.data(), result.coefficients.data());
  else
    multiply_rows<degree - 1>(along_2.data(), along_3.data(), result.coefficients.data());
  result.greatest = 0;
  for (std::size_t n = 0; n < index(net_size(jacobian_degree(degree))); ++n) {
    result.coefficients[n] *= terms.weights[n];
    result.greatest = std::max(result.greatest, std::fabs(result.coefficients[n]));
  }
  const double size = greatest_2.x * greatest_3.y + greatest_2.y * greatest_3.x;
  result.error = (terms.most_terms + 10) * unit_roundoff * (degree * degree * size) + 0x1p-1000;
}

template <std::size_t... index>
constexpr auto enclosures(std::index_sequence<index...>) {
  return std::array{&enclose<static_cast<int>(index) + 1>...};
}

}  // namespace

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
  static constexpr auto by_degree = enclosures(std::make_index_sequence<index(max_degree)>());
  assert(1 <= degree && degree <= max_degree && net.size() >= index(net_size(degree)));
  by_degree[index(degree - 1)](net, result);
}

}  // namespace pliant
