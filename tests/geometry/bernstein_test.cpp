// tests/geometry/bernstein_test.cpp: laws of Bernstein polynomials: sums, products, integrals, derivatives.
#include "pliant/geometry/bernstein.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "pliant/geometry/index.h"
#include "support/triangles.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

using Rational = boost::multiprecision::cpp_rational;

std::vector<double> random_values(int count, int seed) {
  Random random(seed);
  std::vector<double> values(index(count));
  for (double& x : values) x = random.real(-1, 1);
  return values;
}

double on_segment(int degree, const std::vector<double>& a, double s) {
  std::vector<double> basis(index(degree + 1));
  bernstein_basis(degree, s, basis);
  double sum = 0;
  for (std::size_t n = 0; n < basis.size(); ++n) sum += basis[n] * a[n];
  return sum;
}

double on_triangle(int degree, const std::vector<double>& a, const Barycentric& xi) {
  std::vector<double> basis(index(net_size(degree)));
  bernstein_basis(degree, xi, basis);
  double sum = 0;
  for (std::size_t n = 0; n < basis.size(); ++n) sum += basis[n] * a[n];
  return sum;
}

Rational factorial(int n) {
  Rational result = 1;
  for (int m = 2; m <= n; ++m) result *= m;
  return result;
}

}  // namespace

TEST_CASE("the Bernstein basis is non-negative and sums to 1", "[geometry]") {
  for (int p = 0; p <= max_net_degree; ++p) {
    std::vector<double> basis(index(net_size(p)));
    for (const Barycentric& xi : lattice(5)) {
      bernstein_basis(p, xi, basis);
      double sum = 0;
      for (const double b : basis) sum += b;
      CHECK(sum == Approx(1).epsilon(1e-13));
      CHECK(*std::min_element(basis.begin(), basis.end()) >= 0);
    }
    basis.resize(index(p + 1));
    bernstein_basis(p, 0.3, basis);
    double sum = 0;
    for (const double b : basis) sum += b;
    CHECK(sum == Approx(1).epsilon(1e-13));
  }
}

TEST_CASE("the value of a product is the product of the values", "[geometry][property]") {
  const int p = GENERATE(0, 1, 2, 3, 5, 9);
  const int q = GENERATE(0, 1, 2, 4, 18);
  CAPTURE(p, q);
  const auto a = random_values(net_size(p), 10 * p + q);
  const auto b = random_values(net_size(q), 10 * q + p + 1);
  std::vector<double> product(index(net_size(p + q)));
  multiply_triangle(p, a, q, b, product);
  for (const Barycentric& xi : lattice(6))
    CHECK(on_triangle(p + q, product, xi) == Approx(on_triangle(p, a, xi) * on_triangle(q, b, xi)).margin(1e-13));
  multiply_segment(p, a, q, b, product);
  for (double s = 0; s <= 1; s += 0.0625)
    CHECK(on_segment(p + q, product, s) == Approx(on_segment(p, a, s) * on_segment(q, b, s)).margin(1e-13));
}

TEST_CASE("monomials integrate to i! j! k! / (p + 2)!", "[geometry][oracle]") {
  for (int p = 0; p <= 12; ++p) {
    const NetLayout& layout = NetLayout::of(p);
    for (int n = 0; n < layout.size(); ++n) {
      const auto [i, j, k] = layout.exponents(n);
      std::vector<double> a(index(layout.size()), 0.0);
      a[index(n)] = 1 / layout.multinomial(n);
      const Rational exact = factorial(i) * factorial(j) * factorial(k) / factorial(p + 2);
      CHECK(integrate_triangle(p, a) == Approx(exact.convert_to<double>()).epsilon(1e-14));
    }
  }
  const std::vector<double> ends{3, 5, 7};
  CHECK(integrate_segment(2, ends) == Approx(5));
}

TEST_CASE("the derivative of a polynomial is the one that calculus gives", "[geometry]") {
  // The polynomial is xi1 xi2^2 + xi3^3, so d/dxi2 - d/dxi1 = 2 xi1 xi2 - xi2^2 and d/dxi3 - d/dxi1 = 3 xi3^2 - xi2^2.
  const NetLayout& layout = NetLayout::of(3);
  std::vector<double> a(10, 0.0), along_2(6), along_3(6);
  a[index(layout.index(1, 2))] = 1.0 / 3;
  a[index(layout.index(0, 0))] = 1;
  differentiate_triangle(3, a, along_2, along_3);
  for (const Barycentric& xi : lattice(5)) {
    CHECK(on_triangle(2, along_2, xi) == Approx(2 * xi[0] * xi[1] - xi[1] * xi[1]).margin(1e-14));
    CHECK(on_triangle(2, along_3, xi) == Approx(3 * xi[2] * xi[2] - xi[1] * xi[1]).margin(1e-14));
  }
  const std::vector<double> cube{0, 0, 0, 1};
  std::vector<double> slope(3);
  differentiate_segment(3, cube, slope);
  CHECK(slope == std::vector<double>{0, 0, 3});
}

TEST_CASE("integrating a derivative gives the difference of the ends", "[geometry][property]") {
  const int p = GENERATE(range(1, 20));
  const auto a = random_values(p + 1, p);
  std::vector<double> slope(index(p));
  differentiate_segment(p, a, slope);
  CHECK(integrate_segment(p - 1, slope) == Approx(a[index(p)] - a[0]).margin(1e-13));
}

TEST_CASE("the mass matrix is the exact Gram matrix", "[geometry][oracle]") {
  for (const int p : {0, 1, 2, 3, 5, 10}) {
    const NetLayout& layout = NetLayout::of(p);
    const auto matrix = mass_matrix(p);
    const auto size = index(layout.size());
    REQUIRE(matrix.size() == size * size);
    for (int m = 0; m < layout.size(); m += p < 5 ? 1 : 7) {
      for (int n = 0; n < layout.size(); ++n) {
        const auto& e = layout.exponents(m);
        const auto& f = layout.exponents(n);
        Rational exact = factorial(p) * factorial(p) / factorial(2 * p + 2);
        for (std::size_t c = 0; c < 3; ++c) exact *= factorial(e[c] + f[c]) / (factorial(e[c]) * factorial(f[c]));
        CHECK(matrix[index(m) * size + index(n)] == Approx(exact.convert_to<double>()).epsilon(1e-14));
      }
    }
  }
}
