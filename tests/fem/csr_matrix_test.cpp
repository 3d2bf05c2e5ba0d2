// tests/fem/csr_matrix_test.cpp: products, sums and norms of sparse matrices.
#include "pliant/fem/csr_matrix.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace pliant;

namespace {

CsrMatrix example() {
  return {std::make_shared<CsrPattern>(CsrPattern{{0, 2, 3, 3, 5}, {0, 2, 1, 0, 3}}), {1, 2, 3, 4, 5}};
}

}  // namespace

TEST_CASE("a pattern finds its own entries and no others", "[fem]") {
  const CsrMatrix a = example();
  const int places[4][4] = {{0, -1, 1, -1}, {-1, 2, -1, -1}, {-1, -1, -1, -1}, {3, -1, -1, 4}};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) CHECK(a.pattern->find(i, j) == places[i][j]);
}

TEST_CASE("a product is that of the rows", "[fem]") {
  const std::vector<double> x{1, 10, 100, 1000};
  std::vector<double> y(4, -1);
  multiply(example(), x, y);
  CHECK(y == std::vector<double>{201, 30, 0, 5004});
}

TEST_CASE("a dot product of any length is the sum of its terms", "[fem]") {
  for (std::size_t n = 0; n < 12; ++n) {
    std::vector<double> a(n), b(n);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      a[i] = static_cast<double>(i + 1);
      b[i] = static_cast<double>(3 * i) - 7;
      sum += a[i] * b[i];  // whole numbers: exact
    }
    CHECK(dot(a, b) == sum);
  }
}

TEST_CASE("a dot product does not depend on where its numbers lie in memory", "[fem]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> a(1003), b(1003);
  for (double& x : a) x = uniform(random);
  for (double& x : b) x = uniform(random);
  const double expected = dot(a, b);
  for (std::size_t shift = 1; shift < 9; ++shift) {
    std::vector<double> moved(shift, 0), other(2 * shift, 0);
    moved.insert(moved.end(), a.begin(), a.end());
    other.insert(other.end(), b.begin(), b.end());
    CHECK(dot(std::span<const double>(moved).subspan(shift), std::span<const double>(other).subspan(2 * shift)) ==
          expected);
  }
}

TEST_CASE("a norm scales with its numbers, also where their squares are out of range", "[fem]") {
  for (const double scale : {1.0, 0x1p-500, 0x1p-900, 0x1p600, 0x1p1000, -0x1p1000}) {
    CAPTURE(scale);
    const std::vector<double> a{3 * scale, 0, 4 * scale};
    CHECK(norm(a) == Approx(5 * std::abs(scale)).epsilon(1e-15));
  }
  CHECK(norm({}) == 0);
  CHECK(norm(std::vector<double>{0, 0}) == 0);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  CHECK(std::isnan(norm(std::vector<double>{1, nan})));
  CHECK(norm(std::vector<double>{1, -infinity}) == infinity);
}
